// SPDX-License-Identifier: MIT OR Apache-2.0
//! The slider goes as far as every part stays a part, and its positions are those of the field.
#![allow(clippy::float_cmp, reason = "limits that nothing narrows come out exactly")]

use boxmorph::boxdef::DeformField;
use boxmorph::search::{Gauge, KeepPlace, KeepSize};
use boxmorph::spectrum::{BLENDER_RANGE, DEFAULT_RANGE, LEAST_SCALE, positions_at, slider_limits};
use glam::Vec3;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

fn uniform(rng: &mut ChaCha8Rng, low: f32, high: f32) -> f32 {
    low + (high - low) * (rng.next_u32() as f32 / u32::MAX as f32)
}

fn random_scales(rng: &mut ChaCha8Rng, rows: usize) -> Vec<Vec3> {
    (0..rows).map(|_| Vec3::from_array(std::array::from_fn(|_| uniform(rng, 0.3, 3.1)))).collect()
}

fn least_factor(scales: &[Vec3], gauge_scale: f32, alpha: f32) -> f64 {
    let factor = |c: f32| 1.0 + f64::from(alpha) * (f64::from(gauge_scale) * f64::from(c) - 1.0);
    scales.iter().flat_map(Vec3::to_array).map(factor).fold(f64::INFINITY, f64::min)
}

#[test]
fn every_part_keeps_its_least_scale_and_the_slider_ends_no_earlier_than_it_must() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for _ in 0..500 {
        let rows = 1 + (rng.next_u32() % 8) as usize;
        let scales = random_scales(&mut rng, rows);
        let gauge = uniform(&mut rng, 0.4, 1.6);
        for widest in [DEFAULT_RANGE, BLENDER_RANGE, [-50.0, 50.0]] {
            let limits = slider_limits(&scales, gauge, widest);
            assert!(limits.min <= 0.0 && limits.max >= 1.0);
            assert!(limits.min >= widest[0].max(-10.0) && limits.max <= widest[1].min(10.0));
            for (end, open) in [(limits.min, widest[0].max(-10.0)), (limits.max, widest[1].min(10.0))] {
                let least = least_factor(&scales, gauge, end);
                assert!(least >= f64::from(LEAST_SCALE) - 1e-12, "{least} at {end}");
                let further = least_factor(&scales, gauge, end * 1.001);
                assert!(end == open || further < f64::from(LEAST_SCALE), "{end} could go on");
            }
        }
    }
}

#[test]
fn an_unchanged_object_has_the_whole_default_slider() {
    let limits = slider_limits(&[Vec3::ONE; 3], 1.0, DEFAULT_RANGE);
    assert_eq!([limits.min, limits.max], DEFAULT_RANGE);
}

#[test]
fn the_gauge_counts() {
    let scales = [Vec3::splat(2.0)];
    assert!(slider_limits(&scales, 1.0, BLENDER_RANGE).min > -1.0);
    // A box of twice the size, made half as large by the gauge, is the box as it was.
    let limits = slider_limits(&scales, 0.5, BLENDER_RANGE);
    assert_eq!([limits.min, limits.max], BLENDER_RANGE);
}

#[test]
fn object_and_outcome_are_on_every_slider() {
    let limits = slider_limits(&[Vec3::new(0.01, 1.0, 500.0)], 1.0, DEFAULT_RANGE);
    assert_eq!(limits.max, 1.0);
    assert!(limits.min < 0.0 && limits.min > -0.01);
    let limits = slider_limits(&[Vec3::ONE], 1.0, [0.25, 0.5]);
    assert_eq!([limits.min, limits.max], [0.0, 1.0]);
}

#[test]
fn the_spectrum_of_an_outcome_is_the_field_at_that_fraction_of_its_scales() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let (rows, vertices) = (4, 30);
    let rest: Vec<Vec3> = (0..vertices)
        .map(|_| Vec3::from_array(std::array::from_fn(|_| uniform(&mut rng, -1.0, 1.0))))
        .collect();
    let basis = (0..3 * rows * vertices).map(|_| uniform(&mut rng, -1.0, 1.0)).collect();
    let field = DeformField::new(rest.clone(), rows, basis);
    let scales = random_scales(&mut rng, rows);
    let outcome = field.deform(&scales);
    for alpha in [-1.0, 0.0, 0.3, 1.0, 1.5] {
        let fraction: Vec<Vec3> = scales.iter().map(|c| 1.0 + alpha * (c - 1.0)).collect();
        let pairs = positions_at(&rest, &outcome, alpha).into_iter().zip(field.deform(&fraction));
        for (mixed, deformed) in pairs {
            assert!(mixed.distance(deformed) < 1e-5, "{mixed} and {deformed} at {alpha}");
        }
    }
}

#[test]
fn the_ends_of_a_gauged_spectrum_are_object_and_outcome() {
    let rest = [Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0)];
    let mut outcome = [Vec3::splat(-4.0), Vec3::new(3.0, 1.0, 0.5)];
    Gauge::new(&rest, &outcome, KeepSize::Diagonal, KeepPlace::BottomCenter).apply(&mut outcome);
    assert_eq!(positions_at(&rest, &outcome, 0.0), rest);
    for (mixed, expected) in positions_at(&rest, &outcome, 1.0).iter().zip(outcome) {
        assert!(mixed.distance(expected) < 1e-6);
    }
}
