// SPDX-License-Identifier: MIT OR Apache-2.0
//! Images with alpha onto a background.

/// The backgrounds of the reference protocol: black, white, orange.
pub const BACKGROUNDS: [[u8; 3]; 3] = [[0, 0, 0], [255, 255, 255], [255, 128, 0]];

/// Turns straight alpha of RGBA8 pixels into premultiplied alpha, each channel rounded to nearest: the pixels before
/// black, with their alpha.
pub fn premultiply(rgba: &mut [u8]) {
    for pixel in rgba.as_chunks_mut::<4>().0.iter_mut().filter(|pixel| pixel[3] < 255) {
        let alpha = u32::from(pixel[3]);
        for channel in &mut pixel[..3] {
            *channel = ((u32::from(*channel) * alpha + 127) / 255) as u8;
        }
    }
}

/// Lays RGBA8 pixels with straight alpha over `background`, as RGB8 pixels into `out_rgb`.
///
/// Each channel is `(c·α + b·(255 − α) + 127) / 255` in integers: the nearest value, the same everywhere.
///
/// # Panics
/// If the lengths are not 4 and 3 times the same number of pixels.
pub fn composite(rgba: &[u8], background: [u8; 3], out_rgb: &mut [u8]) {
    assert!(rgba.len().is_multiple_of(4), "four bytes a pixel");
    assert_eq!(rgba.len() / 4 * 3, out_rgb.len(), "three bytes out for four bytes in");
    for (pixel, out) in rgba.chunks_exact(4).zip(out_rgb.chunks_exact_mut(3)) {
        let alpha = u32::from(pixel[3]);
        for channel in 0..3 {
            let (c, b) = (u32::from(pixel[channel]), u32::from(background[channel]));
            out[channel] = ((c * alpha + b * (255 - alpha) + 127) / 255) as u8;
        }
    }
}
