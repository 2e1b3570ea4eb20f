// SPDX-License-Identifier: MIT OR Apache-2.0
//! One of a guide's two networks, cut out of its ONNX file and brought to one form: 32-bit pixels or 64-bit token
//! ids in, 32-bit embeddings out.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use prost::Message;
use prost::bytes::Bytes;

use super::GuideError;
use super::onnx::{Graph, Model, Node, ValueInfo, elem};

/// What a network embeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    Vision,
    Text,
}

/// What an input of the text network holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TextInput {
    Ids,
    Mask,
    Positions,
    Types,
}

/// A network that ONNX Runtime can open, and what is known of it beforehand.
#[derive(Clone)]
pub struct Network {
    /// Its file's name, for errors.
    pub file: String,
    pub model: Bytes,
    /// Files with weights outside the model, by the names it knows them under.
    pub external: Vec<(String, Arc<[u8]>)>,
    /// Names of the inputs, and their fixed lengths of axes.
    pub inputs: Vec<(String, Vec<Option<usize>>)>,
    /// The output that holds one embedding a row.
    pub output: String,
    /// Tokens that the text network knows, where that can be seen.
    pub vocabulary: Option<usize>,
    /// What its weights are kept in.
    pub weights: Weights,
}

/// Numbers that a network's weights are kept in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Weights {
    /// Most of them, where they are of a known kind.
    pub most: Option<&'static str>,
    /// Whether any of them is a byte, or several in one.
    pub has_bytes: bool,
}

impl Network {
    /// Cuts the network for `role` out of a model that may hold both.
    pub fn of_model(
        file: &str,
        bytes: &Bytes,
        external: &[(String, Arc<[u8]>)],
        role: Role,
    ) -> Result<Self, GuideError> {
        let bad = |reason: String| GuideError::BadModel { file: file.into(), reason };
        let mut model = decode(file, bytes)?;
        let graph = model.graph.as_mut().ok_or_else(|| bad("it has no graph".into()))?;
        let output = embedding_output(graph, role).ok_or_else(|| bad("it has no embedding output".into()))?;
        let mut changed = keep_only(graph, &output);
        let mut inputs = Vec::new();
        for input in free_inputs(graph) {
            let shape = input.shape().unwrap_or_default();
            let rank = if role == Role::Vision { 4 } else { 2 };
            if !shape.is_empty() && shape.len() != rank {
                return Err(bad(format!("its input {} has {} axes, not {rank}", input.name(), shape.len())));
            }
            inputs.push((input.name().to_owned(), shape));
        }
        check_inputs(&inputs, role).map_err(bad)?;
        for (name, _) in &inputs {
            changed |= cast_input(graph, name, role).map_err(bad)?;
        }
        changed |= cast_output(graph, &output).map_err(bad)?;
        let vocabulary = if role == Role::Text { vocabulary(graph, &inputs) } else { None };
        let weights = weights(graph);
        let used: HashSet<String> = external_locations(graph).map(|(name, ..)| name.to_owned()).collect();
        Ok(Self {
            file: file.to_owned(),
            model: if changed { model.encode_to_vec().into() } else { bytes.clone() },
            external: external.iter().filter(|(name, _)| used.contains(name)).cloned().collect(),
            inputs,
            output,
            vocabulary,
            weights,
        })
    }

    /// Size of its weights and graph.
    pub fn bytes(&self) -> usize {
        self.model.len() + self.external.iter().map(|(_, data)| data.len()).sum::<usize>()
    }

    /// Images or texts in one run where that is fixed.
    pub fn fixed_batch(&self) -> Option<usize> {
        self.inputs[0].1.first().copied().flatten()
    }

    /// Side of the images where that is fixed: height and width.
    pub fn fixed_image(&self) -> Option<(usize, usize)> {
        match self.inputs[0].1.as_slice() {
            [_, _, Some(height), Some(width)] => Some((*height, *width)),
            _ => None,
        }
    }

    /// Length of a text in tokens where that is fixed.
    pub fn fixed_tokens(&self) -> Option<usize> {
        self.inputs.iter().find_map(|(_, shape)| shape.get(1).copied().flatten())
    }

    /// Whether the text network is told which tokens are padding.
    pub fn has_mask(&self) -> bool {
        self.inputs.iter().any(|(name, _)| text_input(name) == TextInput::Mask)
    }
}

/// Reads a model's message.
pub fn decode(file: &str, bytes: &Bytes) -> Result<Model, GuideError> {
    let bad = |reason: &str| GuideError::BadModel { file: file.into(), reason: reason.into() };
    if bytes.is_empty() {
        return Err(bad("it is empty"));
    }
    Model::decode(bytes.clone()).map_err(|_| bad("it is no ONNX file, or was cut short"))
}

/// The files outside a model that hold its weights: name, and the least length each must have.
pub fn external_files(model: &Model) -> Vec<(String, u64)> {
    let mut files: Vec<(String, u64)> = Vec::new();
    for (name, offset, length) in model.graph.iter().flat_map(external_locations) {
        let end = offset.saturating_add(length.unwrap_or(0));
        match files.iter_mut().find(|(known, _)| known == name) {
            Some((_, least)) => *least = end.max(*least),
            None => files.push((name.to_owned(), end)),
        }
    }
    files.sort();
    files
}

fn external_locations(graph: &Graph) -> impl Iterator<Item = (&str, u64, Option<u64>)> {
    graph.initializer.iter().filter_map(|tensor| tensor.external())
}

pub fn text_input(name: &str) -> TextInput {
    if name.contains("mask") {
        TextInput::Mask
    } else if name.contains("position") {
        TextInput::Positions
    } else if name.contains("type") {
        TextInput::Types
    } else {
        TextInput::Ids
    }
}

fn check_inputs(inputs: &[(String, Vec<Option<usize>>)], role: Role) -> Result<(), String> {
    let names = || inputs.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", ");
    let fits = match role {
        Role::Vision => inputs.len() == 1,
        Role::Text => {
            inputs.iter().filter(|(name, _)| text_input(name) == TextInput::Ids).count() == 1
                && !inputs.iter().any(|(name, _)| name.contains("pixel"))
        }
    };
    if fits {
        return Ok(());
    }
    let wanted = if role == Role::Vision { "images alone" } else { "text alone" };
    let read = if inputs.is_empty() { "nothing".into() } else { names() };
    Err(format!("it does not read {wanted}, but: {read}"))
}

/// Inputs that no initializer fills.
fn free_inputs(graph: &Graph) -> Vec<ValueInfo> {
    let filled: HashSet<&str> = graph.initializer.iter().map(super::onnx::Tensor::name).collect();
    graph.input.iter().filter(|input| !filled.contains(input.name())).cloned().collect()
}

/// The output that holds one embedding a row: by name, or the first of two axes.
fn embedding_output(graph: &Graph, role: Role) -> Option<String> {
    let (own, other) =
        if role == Role::Vision { ("image_embeds", "text_embeds") } else { ("text_embeds", "image_embeds") };
    let fits = |output: &&ValueInfo| {
        output.elem_type().is_some() && output.shape().is_none_or(|shape| shape.len() == 2)
    };
    let named = |wanted: &dyn Fn(&str) -> bool| {
        graph.output.iter().filter(fits).find(|output| wanted(output.name())).map(|o| o.name().to_owned())
    };
    named(&|name| name == own)
        .or_else(|| named(&|name| name.ends_with("_embeds") && name != other))
        .or_else(|| named(&|name| name == "pooler_output"))
        .or_else(|| named(&|name| name != other && !name.starts_with("logits")))
}

/// Drops what `output` does not need, where inputs can be dropped by it: the other encoder of a model that holds
/// both. ONNX Runtime would compute all nodes in every run.
fn keep_only(graph: &mut Graph, output: &str) -> bool {
    let producers: HashMap<&str, usize> = graph
        .node
        .iter()
        .enumerate()
        .flat_map(|(index, node)| node.output.iter().map(move |name| (name.as_str(), index)))
        .collect();
    let mut needed: HashSet<&str> = HashSet::from([output]);
    let mut open = vec![output];
    let mut keep = vec![false; graph.node.len()];
    while let Some(name) = open.pop() {
        let Some(&index) = producers.get(name) else { continue };
        if std::mem::replace(&mut keep[index], true) {
            continue;
        }
        let mut read = Vec::new();
        names_read(&graph.node[index], &mut read);
        open.extend(read.into_iter().filter(|name| needed.insert(name)));
    }
    if graph.input.iter().all(|input| needed.contains(input.name())) {
        return false;
    }
    let needed: HashSet<String> = needed.into_iter().map(str::to_owned).collect();
    let mut keep = keep.into_iter();
    graph.node.retain(|_| keep.next().unwrap_or(false));
    graph.initializer.retain(|tensor| needed.contains(tensor.name()));
    graph.input.retain(|input| needed.contains(input.name()));
    graph.output.retain(|kept| kept.name() == output);
    graph.value_info.retain(|value| needed.contains(value.name()));
    graph.quantization_annotation.clear();
    true
}

/// What a node reads, the graphs inside it included.
pub fn names_read<'g>(node: &'g Node, names: &mut Vec<&'g str>) {
    names.extend(node.input.iter().map(String::as_str).filter(|name| !name.is_empty()));
    for inner in node.graphs() {
        names.extend(inner.output.iter().map(ValueInfo::name));
        for node in &inner.node {
            names_read(node, names);
        }
    }
}

/// Takes 32-bit pixels, or 64-bit token ids, whatever the network itself reads.
fn cast_input(graph: &mut Graph, name: &str, role: Role) -> Result<bool, String> {
    let (fed, known): (i32, &[i32]) = match role {
        Role::Vision => (elem::FLOAT, &[elem::FLOAT16, elem::BFLOAT16, elem::DOUBLE]),
        Role::Text => (elem::INT64, &[elem::INT32, elem::FLOAT, elem::FLOAT16, elem::BOOL]),
    };
    let Some(input) = graph.input.iter_mut().find(|input| input.name() == name) else { return Ok(false) };
    match input.elem_type() {
        Some(own) if own == fed => Ok(false),
        Some(own) if known.contains(&own) => {
            input.set_elem_type(fed);
            let inside = format!("{name}/boxmorph");
            graph.rename(name, &inside);
            graph.node.insert(0, Node::cast(name, &inside, own));
            Ok(true)
        }
        _ => Err(format!("its input {name} holds numbers of a kind that no guide reads")),
    }
}

/// Gives 32-bit embeddings, whatever the network itself makes.
fn cast_output(graph: &mut Graph, name: &str) -> Result<bool, String> {
    let Some(output) = graph.output.iter_mut().find(|output| output.name() == name) else { return Ok(false) };
    match output.elem_type() {
        Some(elem::FLOAT) => Ok(false),
        Some(elem::FLOAT16 | elem::BFLOAT16 | elem::DOUBLE) => {
            output.set_elem_type(elem::FLOAT);
            let inside = format!("{name}/boxmorph");
            graph.rename(name, &inside);
            graph.value_info.retain(|value| value.name() != name);
            graph.node.push(Node::cast(&inside, name, elem::FLOAT));
            Ok(true)
        }
        _ => Err(format!("its output {name} holds no real numbers")),
    }
}

/// What the weights of a graph are kept in.
fn weights(graph: &Graph) -> Weights {
    let kinds = [
        ("fp32", elem::FLOAT),
        ("fp16", elem::FLOAT16),
        ("bf16", elem::BFLOAT16),
        ("int8", elem::INT8),
        ("uint8", elem::UINT8),
    ];
    let count = |kind: i32| -> f64 {
        let those = graph.initializer.iter().filter(|weight| weight.data_type == Some(kind));
        // No counts of elements, which may be nonsense in a damaged file.
        those.map(|weight| weight.dims.iter().map(|&length| length as f64).product::<f64>()).sum()
    };
    let most = kinds.iter().map(|&(name, kind)| (name, count(kind))).max_by(|a, b| a.1.total_cmp(&b.1));
    let has_bytes = count(elem::INT8) + count(elem::UINT8) > 0.0;
    Weights { most: most.filter(|(_, count)| *count > 0.0).map(|(name, _)| name), has_bytes }
}

/// The rows of the table in which token ids are looked up.
fn vocabulary(graph: &Graph, inputs: &[(String, Vec<Option<usize>>)]) -> Option<usize> {
    let (ids, _) = inputs.iter().find(|(name, _)| text_input(name) == TextInput::Ids)?;
    let rows: HashMap<&str, i64> =
        graph.initializer.iter().filter_map(|t| Some((t.name(), *t.dims.first()?))).collect();
    let mut same = HashSet::from([ids.as_str()]);
    // A table that is stored in fewer bits passes through one of these first.
    let mut tables: HashMap<&str, i64> = rows.clone();
    for node in &graph.node {
        let (Some(first), Some(output)) = (node.input.first(), node.output.first()) else { continue };
        match node.op_type() {
            "Cast" | "Identity" | "DequantizeLinear" | "Reshape" | "Unsqueeze" | "Squeeze" | "Flatten" => {
                if same.contains(first.as_str()) {
                    same.insert(output);
                } else if matches!(node.op_type(), "Cast" | "Identity" | "DequantizeLinear")
                    && let Some(rows) = tables.get(first.as_str()).copied()
                {
                    tables.insert(output, rows);
                }
            }
            "Gather" if node.input.get(1).is_some_and(|index| same.contains(index.as_str())) => {
                return tables.get(first.as_str()).and_then(|rows| usize::try_from(*rows).ok());
            }
            _ => {}
        }
    }
    None
}
