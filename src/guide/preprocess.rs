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
    pub fn from_json(bytes: &[u8]) -> Result<Self, GuideError> {
        let bad = |reason: &str| GuideError::BadJson { file: FILE, reason: reason.into() };
        let json: Value = serde_json::from_slice(bytes).map_err(|e| bad(&e.to_string()))?;
        let size = ["/crop_size/height", "/crop_size", "/size/height", "/size/shortest_edge", "/size"]
            .iter()
            .find_map(|pointer| json.pointer(pointer).and_then(Value::as_u64))
            .ok_or_else(|| bad("it names no image size"))?;
        if !(8..=2048).contains(&size) {
            return Err(bad("its image size is not within 8 to 2048"));
        }
        let scale = json.get("rescale_factor").and_then(Value::as_f64).unwrap_or(1.0 / 255.0);
        let mean = triple(&json, "image_mean").ok_or_else(|| bad("image_mean is not three numbers"))?;
        let std = triple(&json, "image_std").ok_or_else(|| bad("image_std is not three numbers"))?;
        if std.iter().any(|s| *s <= 0.0) {
            return Err(bad("image_std is not positive"));
        }
        Ok(Self { size: size as u32, scale, mean, std })
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

fn triple(json: &Value, key: &str) -> Option<[f64; 3]> {
    let values: Vec<f64> = json.get(key)?.as_array()?.iter().filter_map(Value::as_f64).collect();
    values.try_into().ok()
}
