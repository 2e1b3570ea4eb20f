// SPDX-License-Identifier: MIT OR Apache-2.0
//! What a network wants its pixels to be, as `preprocessor_config.json` says.

use serde_json::Value;

use super::GuideError;

const FILE: &str = "preprocessor_config.json";

/// Image size, and how bytes become a network's numbers: `(byte × scale − mean) / std` in each channel.
#[derive(Debug)]
pub struct Preprocess {
    pub size: u32,
    scale: f64,
    mean: [f64; 3],
    std: [f64; 3],
}

impl Preprocess {
    pub fn from_json(json: &Value) -> Result<Self, GuideError> {
        let bad = |reason: &str| GuideError::BadJson { file: FILE, reason: reason.into() };
        let on = |key: &str| json.get(key).and_then(Value::as_bool).unwrap_or(true);
        let cropped = json.get("crop_size").filter(|_| on("do_center_crop")).and_then(side);
        let size = cropped
            .or_else(|| json.get("size").and_then(side))
            .ok_or_else(|| bad("it names no image size"))?;
        if size[0] != size[1] {
            return Err(bad("its images are not square"));
        }
        if !(8..=2048).contains(&size[0]) {
            return Err(bad("its image size is not within 8 to 2048"));
        }
        let scale = json.get("rescale_factor").and_then(Value::as_f64).unwrap_or(1.0 / 255.0);
        let scale = if on("do_rescale") { scale } else { 1.0 };
        let (mean, std) = if on("do_normalize") {
            let numbers =
                |key: &str| triple(json, key).ok_or_else(|| bad(&format!("{key} is not three numbers")));
            (numbers("image_mean")?, numbers("image_std")?)
        } else {
            ([0.0; 3], [1.0; 3])
        };
        if std.iter().any(|s| *s <= 0.0) {
            return Err(bad("image_std is not positive"));
        }
        Ok(Self { size: size[0] as u32, scale, mean, std })
    }

    /// What [`super::prologue`] takes to put premultiplied RGBA before each of the `backgrounds`: 3 × 4 and 3 × 1
    /// numbers a background.
    pub fn mix(&self, backgrounds: impl Iterator<Item = [u8; 3]>, mix: &mut Vec<f32>, base: &mut Vec<f32>) {
        mix.clear();
        base.clear();
        for background in backgrounds {
            for (channel, byte) in background.into_iter().enumerate() {
                let (behind, std) = (f64::from(byte) * self.scale, self.std[channel]);
                let mut row = [0.0; 4];
                row[channel] = (self.scale / std) as f32;
                row[3] = (-behind / 255.0 / std) as f32;
                mix.extend(row);
                base.push(((behind - self.mean[channel]) / std) as f32);
            }
        }
    }
}

/// Height and width of a size in one of the forms that it has.
fn side(size: &Value) -> Option<[u64; 2]> {
    let of = |key: &str| size.get(key).and_then(Value::as_u64);
    if let Some(side) = size.as_u64().or_else(|| of("shortest_edge")) {
        return Some([side, side]);
    }
    Some([of("height")?, of("width")?])
}

fn triple(json: &Value, key: &str) -> Option<[f64; 3]> {
    let values: Vec<f64> = json.get(key)?.as_array()?.iter().filter_map(Value::as_f64).collect();
    values.try_into().ok()
}
