// SPDX-License-Identifier: MIT OR Apache-2.0
//! Where a guide's networks lie in its folder: one file or two, in which precision.

use std::path::{Path, PathBuf};

use super::GuideError;
use super::disk::regular_file;

/// Folders looked into, one after the other.
const PLACES: [&str; 2] = ["", "onnx"];

/// Names of an image network and its text network.
const PAIRS: [(&str, &str); 4] = [
    ("vision_model", "text_model"),
    ("vision_encoder", "text_encoder"),
    ("image_encoder", "text_encoder"),
    ("visual", "textual"),
];

/// Name of a network that holds both encoders.
const COMBINED: &str = "model";

/// A precision by its name here and the endings of its files' names, the most exact first.
const PRECISIONS: [(&str, &[&str]); 7] = [
    ("fp32", &[""]),
    ("fp16", &["_fp16"]),
    ("int8", &["_int8", "_quantized"]),
    ("uint8", &["_uint8"]),
    ("q4", &["_q4"]),
    ("q4f16", &["_q4f16"]),
    ("bnb4", &["_bnb4"]),
];

/// The files of a guide's networks.
#[derive(Debug, PartialEq, Eq)]
pub struct Layout {
    pub networks: Networks,
    /// The image network's precision.
    pub precision: &'static str,
}

#[derive(Debug, PartialEq, Eq)]
pub enum Networks {
    /// The text network may lie in a file that holds both.
    Separate {
        vision: PathBuf,
        text: PathBuf,
    },
    Combined(PathBuf),
}

impl Layout {
    /// Finds the networks of `precision` in `folder`; of the most exact where that is None.
    ///
    /// In the same precision two networks come before one that holds both. An image and a text network of
    /// different precisions are a pair where nothing else is there.
    pub fn find(folder: &Path, precision: Option<&str>) -> Result<Self, GuideError> {
        if let Some(wanted) = precision
            && !PRECISIONS.iter().any(|(name, _)| *name == wanted)
        {
            let known = PRECISIONS.map(|(name, _)| format!("\"{name}\"")).join(", ");
            return Err(GuideError::UnknownPrecision { name: wanted.into(), known });
        }
        let admitted =
            || PRECISIONS.iter().filter(|(name, _)| precision.is_none_or(|wanted| *name == wanted));
        for (precision, endings) in admitted() {
            for ending in *endings {
                for (vision, text) in PAIRS {
                    if let (Some(vision), Some(text)) =
                        (network(folder, vision, ending)?, network(folder, text, ending)?)
                    {
                        return Ok(Self { networks: Networks::Separate { vision, text }, precision });
                    }
                }
                if let Some(both) = network(folder, COMBINED, ending)? {
                    return Ok(Self { networks: Networks::Combined(both), precision });
                }
            }
        }
        // Wanted for its speed with images; the text network may be the exact one.
        let mut missing = PAIRS[0].0;
        for (vision, text) in PAIRS {
            let vision = first(folder, vision, &mut admitted())?;
            let text_file = match first(folder, text, &mut PRECISIONS.iter())? {
                None => first(folder, COMBINED, &mut PRECISIONS.iter())?,
                own => own,
            };
            match (vision, text_file) {
                (Some((vision, precision)), Some((text, _))) => {
                    return Ok(Self { networks: Networks::Separate { vision, text }, precision });
                }
                (Some(_), None) => missing = text,
                _ => {}
            }
        }
        let folder = folder.display().to_string();
        match precision {
            Some(precision) => Err(GuideError::NoPrecision { folder, precision: precision.into() }),
            None => Err(GuideError::MissingFile { folder, file: format!("{missing}.onnx") }),
        }
    }
}

type Precision = (&'static str, &'static [&'static str]);

fn first(
    folder: &Path,
    stem: &str,
    precisions: &mut dyn Iterator<Item = &Precision>,
) -> Result<Option<(PathBuf, &'static str)>, GuideError> {
    for (precision, endings) in precisions {
        for ending in *endings {
            if let Some(path) = network(folder, stem, ending)? {
                return Ok(Some((path, precision)));
            }
        }
    }
    Ok(None)
}

fn network(folder: &Path, stem: &str, ending: &str) -> Result<Option<PathBuf>, GuideError> {
    for place in PLACES {
        let path = folder.join(place).join(format!("{stem}{ending}.onnx"));
        if regular_file(&path)? {
            return Ok(Some(path));
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An empty folder of the test's own with these files, removed by the next run.
    fn folder(test: &str, files: &[&str]) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("boxmorph-layout-{test}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(folder.join("onnx")).unwrap();
        for file in files {
            std::fs::write(folder.join(file), b"").unwrap();
        }
        folder
    }

    fn found(
        test: &str,
        files: &[&str],
        precision: Option<&str>,
    ) -> Result<(Vec<String>, &'static str), String> {
        let folder = folder(test, files);
        let layout = Layout::find(&folder, precision).map_err(|error| error.to_string());
        let name =
            |path: PathBuf| path.strip_prefix(&folder).unwrap().display().to_string().replace('\\', "/");
        let all = layout.map(|layout| {
            let files = match layout.networks {
                Networks::Separate { vision, text } => vec![name(vision), name(text)],
                Networks::Combined(both) => vec![name(both)],
            };
            (files, layout.precision)
        });
        std::fs::remove_dir_all(&folder).unwrap();
        all
    }

    #[test]
    fn the_most_exact_is_taken_and_two_before_one() {
        let files = [
            "onnx/model.onnx",
            "onnx/vision_model.onnx",
            "onnx/text_model.onnx",
            "onnx/vision_model_fp16.onnx",
            "onnx/text_model_fp16.onnx",
        ];
        let (names, precision) = found("exact", &files, None).unwrap();
        assert_eq!(names, ["onnx/vision_model.onnx", "onnx/text_model.onnx"]);
        assert_eq!(precision, "fp32");
        let (names, precision) = found("fp16", &files, Some("fp16")).unwrap();
        assert_eq!(names, ["onnx/vision_model_fp16.onnx", "onnx/text_model_fp16.onnx"]);
        assert_eq!(precision, "fp16");
    }

    #[test]
    fn one_file_may_hold_both() {
        let (names, precision) = found("both", &["model_quantized.onnx"], None).unwrap();
        assert_eq!((names.as_slice(), precision), (["model_quantized.onnx".to_owned()].as_slice(), "int8"));
    }

    #[test]
    fn an_exact_text_network_goes_with_images_in_eight_bits() {
        let files = ["vision_model_int8.onnx", "onnx/text_model.onnx"];
        for precision in [None, Some("int8")] {
            let (names, precision) = found("mixed", &files, precision).unwrap();
            assert_eq!((names.as_slice(), precision), (files.map(str::to_owned).as_slice(), "int8"));
        }
    }

    #[test]
    fn a_text_network_may_be_half_of_one_that_holds_both() {
        let files = ["onnx/vision_model_int8.onnx", "onnx/model.onnx"];
        let (names, precision) = found("part", &files, Some("int8")).unwrap();
        assert_eq!((names.as_slice(), precision), (files.map(str::to_owned).as_slice(), "int8"));
        assert_eq!(found("part", &files, None).unwrap().1, "fp32");
    }

    #[test]
    fn what_is_missing_is_named() {
        let missing = found("half", &["visual.onnx"], None).unwrap_err();
        assert!(missing.contains("has no textual.onnx"), "{missing}");
        let missing = found("none", &[], None).unwrap_err();
        assert!(missing.contains("has no vision_model.onnx"), "{missing}");
        let missing = found("precision", &["model.onnx"], Some("int8")).unwrap_err();
        assert!(missing.contains("no networks in the precision \"int8\""), "{missing}");
        let unknown = found("unknown", &["model.onnx"], Some("int7")).unwrap_err();
        assert!(unknown.contains("unknown precision \"int7\": choose \"fp32\""), "{unknown}");
    }
}
