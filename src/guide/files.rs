// SPDX-License-Identifier: MIT OR Apache-2.0
//! A guide's files, from a folder or from the library itself.

use std::path::{Component, Path};
use std::sync::Arc;

use prost::bytes::Bytes;
use serde_json::Value;
use sha2::{Digest, Sha256};

use super::GuideError;
use super::disk::{optional, read, regular_file, required};
use super::layout::{Layout, Networks};
use super::network::{Network, Role, Weights, decode, external_files};

/// Largest ONNX file: protobuf itself reads no more than 2 GiB. Weights beyond are kept in other files.
const MAX_NETWORK_BYTES: u64 = 2 << 30;

/// Most bytes of weights in other files.
const MAX_WEIGHT_BYTES: u64 = 16 << 30;

/// Longest text of any guide, in tokens.
pub const MAX_TOKENS: usize = 4096;

/// Files that say more of the tokenizer and are not in every folder.
const TOKENIZER_CONFIG: &str = "tokenizer_config.json";

/// A guide's networks, the bytes of its other files and its parsed configuration.
#[derive(Clone)]
pub struct GuideFiles {
    pub name: String,
    pub vision: Network,
    pub text: Network,
    pub preprocessor: Value,
    pub precision: &'static str,
    tokenizer_config: Value,
    config: Value,
    sources: Vec<Source>,
    files: OtherFiles,
}

impl GuideFiles {
    /// Reads a folder; see [`Layout`] for where the networks may lie.
    pub fn read(folder: &Path, precision: Option<&str>) -> Result<Self, GuideError> {
        if !folder.is_dir() {
            return Err(GuideError::NoFolder(folder.display().to_string()));
        }
        let name = name(folder);
        let layout = Layout::find(folder, precision)?;
        let tokenizer = required(folder, "tokenizer.json")?;
        // Newer exports keep the image processor's settings beside the others'.
        let preprocessor = match optional(folder, "preprocessor_config.json")? {
            Some(own) => own,
            None => match optional(folder, "processor_config.json")? {
                Some(shared) => shared,
                None => required(folder, "preprocessor_config.json")?,
            },
        };
        let config = required(folder, "config.json")?;
        let extra = optional(folder, TOKENIZER_CONFIG)?;
        let (sources, vision, text) = match &layout.networks {
            Networks::Separate { vision, text } => {
                let read = |path: &Path, role| -> Result<_, GuideError> {
                    let source = Source::read(path)?;
                    let network = source.network(role)?;
                    Ok((source, network))
                };
                let (vision, text) = rayon::join(|| read(vision, Role::Vision), || read(text, Role::Text));
                let ((vision, vision_network), (text, text_network)) = (vision?, text?);
                (vec![vision, text], vision_network, text_network)
            }
            Networks::Combined(path) => {
                let both = Source::read(path)?;
                let networks = (both.network(Role::Vision)?, both.network(Role::Text)?);
                (vec![both], networks.0, networks.1)
            }
        };
        let files = OtherFiles { tokenizer, preprocessor, config, tokenizer_config: extra };
        Self::new(name, sources, (vision, text), files, layout.precision)
    }

    /// The guide compiled into the library.
    pub fn embedded() -> Result<Self, GuideError> {
        let source = |file: &str, bytes: &'static [u8]| Source {
            file: file.into(),
            model: Bytes::from_static(bytes),
            external: Vec::new(),
        };
        let vision = source("vision_model.onnx", include_bytes!("../../guides/mini/vision_model.onnx"));
        let text = source("text_model.onnx", include_bytes!("../../guides/mini/text_model.onnx"));
        let networks = (vision.network(Role::Vision)?, text.network(Role::Text)?);
        let files = OtherFiles {
            tokenizer: include_bytes!("../../guides/mini/tokenizer.json").to_vec(),
            preprocessor: include_bytes!("../../guides/mini/preprocessor_config.json").to_vec(),
            config: include_bytes!("../../guides/mini/config.json").to_vec(),
            tokenizer_config: None,
        };
        Self::new("mini".into(), vec![vision, text], networks, files, "fp32")
    }

    fn new(
        name: String,
        sources: Vec<Source>,
        (vision, text): (Network, Network),
        files: OtherFiles,
        precision: &'static str,
    ) -> Result<Self, GuideError> {
        let preprocessor = json("preprocessor_config.json", &files.preprocessor)?;
        Ok(Self {
            name,
            precision: told_precision(precision, vision.weights),
            vision,
            text,
            preprocessor: preprocessor.get("image_processor").cloned().unwrap_or(preprocessor),
            tokenizer_config: match &files.tokenizer_config {
                Some(bytes) => json(TOKENIZER_CONFIG, bytes)?,
                None => Value::Null,
            },
            config: json("config.json", &files.config)?,
            sources,
            files,
        })
    }

    /// The bytes of its tokenizer.
    pub fn tokenizer(&self) -> &[u8] {
        &self.files.tokenizer
    }

    /// SHA-256 over all files in a fixed order, in hexadecimal. Takes some tenths of a second for a large guide.
    pub fn hash(&self) -> String {
        use std::fmt::Write;
        let mut hasher = Sha256::new();
        let models = self.sources.iter().map(|source| source.model.as_ref());
        let OtherFiles { tokenizer, preprocessor, config, tokenizer_config } = &self.files;
        let others = [tokenizer, preprocessor, config].map(Vec::as_slice);
        let weights = self.sources.iter().flat_map(|source| &source.external).map(|(_, data)| data.as_ref());
        for bytes in models.chain(others).chain(tokenizer_config.as_deref()).chain(weights) {
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
        let names = self.config.pointer("/boxmorph/classes").and_then(Value::as_array);
        names.into_iter().flatten().filter_map(|n| n.as_str().map(str::to_owned)).collect()
    }

    /// The configuration's name for the kind of model, such as `clip` or `siglip`.
    pub fn model_type(&self) -> &str {
        self.config.get("model_type").and_then(Value::as_str).unwrap_or_default()
    }

    /// The longest text in tokens that the network has positions for, where the configuration says it.
    pub fn max_positions(&self) -> Option<usize> {
        length(self.config.pointer("/text_config/max_position_embeddings")?)
    }

    /// The longest text in tokens that the tokenizer makes, where it says so.
    pub fn tokenizer_length(&self) -> Option<usize> {
        length(self.tokenizer_config.get("model_max_length")?)
    }

    /// The token that fills a text up, where the tokenizer names it.
    pub fn pad_token(&self) -> Option<&str> {
        let token = self.tokenizer_config.get("pad_token")?;
        token.as_str().or_else(|| token.get("content")?.as_str())
    }

    /// Whether a text is filled up in front of its first word.
    pub fn pads_left(&self) -> bool {
        self.tokenizer_config.get("padding_side").and_then(Value::as_str) == Some("left")
    }

    /// The number of that token, where the configuration says it.
    pub fn pad_id(&self) -> Option<u32> {
        let id = self.config.pointer("/text_config/pad_token_id")?.as_u64()?;
        u32::try_from(id).ok()
    }
}

/// The folder's name; of one in the hub's cache, which is called by a commit, the repository's.
fn name(folder: &Path) -> String {
    let name = |path: &Path| path.file_name().map(|name| name.to_string_lossy().into_owned());
    let repository = || {
        let snapshots = folder.parent().filter(|parent| name(parent).as_deref() == Some("snapshots"))?;
        Some(name(snapshots.parent()?)?.strip_prefix("models--")?.replace("--", "/"))
    };
    repository().or_else(|| name(folder)).unwrap_or_else(|| "guide".into())
}

/// The precision that a file's name says, unless its weights are of another.
fn told_precision(named: &'static str, weights: Weights) -> &'static str {
    let is_float = matches!(named, "fp32" | "fp16");
    match weights.most {
        Some(most) if is_float || !weights.has_bytes => most,
        _ => named,
    }
}

/// A length in tokens; a tokenizer without a longest text has an enormous one.
fn length(value: &Value) -> Option<usize> {
    value.as_u64().map(|n| n as usize).filter(|n| (1..=MAX_TOKENS).contains(n))
}

/// The bytes of the files that are no networks.
#[derive(Clone)]
struct OtherFiles {
    tokenizer: Vec<u8>,
    preprocessor: Vec<u8>,
    config: Vec<u8>,
    tokenizer_config: Option<Vec<u8>>,
}

/// An ONNX file and the files beside it that hold its weights.
#[derive(Clone)]
struct Source {
    file: String,
    model: Bytes,
    external: Vec<(String, Arc<[u8]>)>,
}

impl Source {
    fn read(path: &Path) -> Result<Self, GuideError> {
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let model = Bytes::from(read(path, MAX_NETWORK_BYTES)?);
        let mut external = Vec::new();
        let mut left = MAX_WEIGHT_BYTES;
        for (name, least) in external_files(&decode(&file, &model)?) {
            let bad = |reason: String| GuideError::Weights { file: file.clone(), data: name.clone(), reason };
            // Beside the network, so that a guide reads nothing that is not its own.
            let inside = Path::new(&name).components().all(|part| matches!(part, Component::Normal(_)));
            if name.is_empty() || !inside {
                return Err(bad("is not in its folder".into()));
            }
            let data_path = path.with_file_name(&name);
            if !regular_file(&data_path)? {
                return Err(bad("is missing".into()));
            }
            let data = read(&data_path, left)?;
            if (data.len() as u64) < least {
                return Err(bad(format!("has {} bytes of {least}", data.len())));
            }
            left -= data.len() as u64;
            external.push((name, data.into()));
        }
        Ok(Self { file, model, external })
    }

    fn network(&self, role: Role) -> Result<Network, GuideError> {
        Network::of_model(&self.file, &self.model, &self.external, role)
    }
}

fn json(file: &'static str, bytes: &[u8]) -> Result<Value, GuideError> {
    serde_json::from_slice(bytes).map_err(|e| GuideError::BadJson { file, reason: e.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_guide_in_the_hubs_cache_is_called_by_its_repository() {
        let cached = "hub/models--Xenova--clip-vit-base-patch32/snapshots/0123abc";
        assert_eq!(name(Path::new(cached)), "Xenova/clip-vit-base-patch32");
        assert_eq!(name(Path::new("guides/clip-vit-base-patch32-fp16")), "clip-vit-base-patch32-fp16");
        assert_eq!(name(Path::new("snapshots/mine")), "mine");
    }

    #[test]
    fn a_name_that_is_not_true_is_not_told() {
        let of = |most, has_bytes| Weights { most, has_bytes };
        assert_eq!(told_precision("fp32", of(Some("fp32"), false)), "fp32");
        assert_eq!(told_precision("fp32", of(Some("fp16"), false)), "fp16");
        assert_eq!(told_precision("fp32", of(Some("int8"), true)), "int8");
        assert_eq!(told_precision("fp16", of(Some("fp32"), false)), "fp32");
        assert_eq!(told_precision("int8", of(Some("fp32"), false)), "fp32");
        // Convolutions stay as they are, and eight bits may be with a sign or without.
        assert_eq!(told_precision("int8", of(Some("fp32"), true)), "int8");
        assert_eq!(told_precision("int8", of(Some("uint8"), true)), "int8");
        assert_eq!(told_precision("q4", of(Some("uint8"), true)), "q4");
        assert_eq!(told_precision("fp32", of(None, false)), "fp32");
    }
}
