// SPDX-License-Identifier: MIT OR Apache-2.0
//! Image bytes to network input, as `preprocessor_config.json` says.

use serde_json::Value;

use super::GuideError;

const FILE: &str = "preprocessor_config.json";

/// Image size and the value that each byte becomes in each channel.
#[derive(Debug)]
pub struct Preprocess {
    pub size: u32,
    table: [[f32; 256]; 3],
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
        let table = std::array::from_fn(|channel| {
            std::array::from_fn(|byte| ((byte as f64 * scale - mean[channel]) / std[channel]) as f32)
        });
        Ok(Self { size: size as u32, table })
    }

    /// Converts RGB images (`k × size × size × 3` bytes) into `k × 3 × size × size` numbers.
    pub fn apply(&self, images: &[u8], out: &mut Vec<f32>) {
        let plane = (self.size as usize).pow(2);
        out.clear();
        out.reserve(images.len());
        for image in images.chunks_exact(3 * plane) {
            for (channel, table) in self.table.iter().enumerate() {
                out.extend(image.iter().skip(channel).step_by(3).map(|byte| table[usize::from(*byte)]));
            }
        }
    }
}

fn triple(json: &Value, key: &str) -> Option<[f64; 3]> {
    let values: Vec<f64> = json.get(key)?.as_array()?.iter().filter_map(Value::as_f64).collect();
    values.try_into().ok()
}
