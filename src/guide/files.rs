// SPDX-License-Identifier: MIT OR Apache-2.0
//! A guide's files, from a folder or from the library itself.

use std::path::Path;

use serde_json::Value;
use sha2::{Digest, Sha256};

use super::GuideError;

/// The bytes of a guide and its parsed configuration.
pub struct GuideFiles {
    pub name: String,
    pub vision: Vec<u8>,
    pub text: Vec<u8>,
    pub tokenizer: Vec<u8>,
    pub preprocessor: Vec<u8>,
    config: Vec<u8>,
    config_json: Value,
}

impl GuideFiles {
    /// Reads a folder; the networks may lie in it or under `onnx/`.
    pub fn read(folder: &Path) -> Result<Self, GuideError> {
        if !folder.is_dir() {
            return Err(GuideError::NoFolder(folder.display().to_string()));
        }
        let name = folder.file_name().map_or_else(|| "guide".into(), |n| n.to_string_lossy().into_owned());
        Self::from_bytes(
            name,
            read(folder, &["vision_model.onnx", "onnx/vision_model.onnx"])?,
            read(folder, &["text_model.onnx", "onnx/text_model.onnx"])?,
            read(folder, &["tokenizer.json"])?,
            read(folder, &["preprocessor_config.json"])?,
            read(folder, &["config.json"])?,
        )
    }

    /// The guide compiled into the library.
    pub fn embedded() -> Result<Self, GuideError> {
        Self::from_bytes(
            "mini".into(),
            include_bytes!("../../guides/mini/vision_model.onnx").to_vec(),
            include_bytes!("../../guides/mini/text_model.onnx").to_vec(),
            include_bytes!("../../guides/mini/tokenizer.json").to_vec(),
            include_bytes!("../../guides/mini/preprocessor_config.json").to_vec(),
            include_bytes!("../../guides/mini/config.json").to_vec(),
        )
    }

    fn from_bytes(
        name: String,
        vision: Vec<u8>,
        text: Vec<u8>,
        tokenizer: Vec<u8>,
        preprocessor: Vec<u8>,
        config: Vec<u8>,
    ) -> Result<Self, GuideError> {
        let config_json = serde_json::from_slice(&config)
            .map_err(|e| GuideError::BadJson { file: "config.json", reason: e.to_string() })?;
        Ok(Self { name, vision, text, tokenizer, preprocessor, config, config_json })
    }

    /// SHA-256 over all files in a fixed order, in hexadecimal.
    pub fn hash(&self) -> String {
        use std::fmt::Write;
        let mut hasher = Sha256::new();
        for bytes in [&self.vision, &self.text, &self.tokenizer, &self.preprocessor, &self.config] {
            hasher.update((bytes.len() as u64).to_le_bytes());
            hasher.update(bytes);
        }
        hasher.finalize().iter().fold(String::new(), |mut text, byte| {
            let _ = write!(text, "{byte:02x}");
            text
        })
    }

    /// The names the guide was taught (`boxmorph.classes` of its configuration).
    pub fn classes(&self) -> Vec<String> {
        let names = self.config_json.pointer("/boxmorph/classes").and_then(Value::as_array);
        names.into_iter().flatten().filter_map(|n| n.as_str().map(str::to_owned)).collect()
    }

    /// The longest text in tokens, where the configuration says it.
    pub fn max_tokens(&self) -> Option<usize> {
        let pointer = "/text_config/max_position_embeddings";
        self.config_json.pointer(pointer).and_then(Value::as_u64).map(|n| n as usize)
    }
}

fn read(folder: &Path, places: &[&'static str]) -> Result<Vec<u8>, GuideError> {
    let path =
        places.iter().map(|place| folder.join(place)).find(|path| path.is_file()).ok_or_else(|| {
            GuideError::MissingFile { folder: folder.display().to_string(), file: places[0] }
        })?;
    std::fs::read(&path)
        .map_err(|e| GuideError::Unreadable { path: path.display().to_string(), reason: e.to_string() })
}
