// SPDX-License-Identifier: MIT OR Apache-2.0
//! Matrix products in eight bits: weights once, by column; what they are multiplied with in every run.
//!
//! The network becomes what `onnxruntime.quantization.quantize_dynamic(weight_type=QInt8, per_channel=True)` makes
//! of its matrix products. Convolutions and tables stay as they are: they take little time.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use prost::bytes::Bytes;

use super::onnx::{Attribute, Graph, Model, Node, Tensor, elem};

/// Greatest absolute value of a weight; −128 is left out, so that zero stays zero.
const GREATEST: f32 = 127.0;

/// First version of the standard operators that can quantise what comes in.
const LEAST_OPSET: i64 = 11;

type Files = [(String, Arc<[u8]>)];

/// Puts eight-bit matrix products into a 32-bit network, and all weights into the model. Returns how many products
/// were changed.
pub fn quantize(model: &mut Model, external: &Files) -> Result<usize, String> {
    let standard = |set: &&super::onnx::OperatorSet| matches!(set.domain(), "" | "ai.onnx");
    let opset = model.opset_import.iter().find(standard).map_or(0, super::onnx::OperatorSet::version);
    if opset < LEAST_OPSET {
        return Err(format!("its operators are of version {opset}, and eight bits need {LEAST_OPSET}"));
    }
    let graph = model.graph.as_mut().ok_or("it has no graph")?;
    let mut made = Made::default();
    let weights: HashMap<String, Tensor> =
        graph.initializer.iter().map(|tensor| (tensor.name().to_owned(), tensor.clone())).collect();
    let mut nodes = Vec::with_capacity(graph.node.len());
    let mut count = 0;
    for node in std::mem::take(&mut graph.node) {
        match Product::of(&node).and_then(|product| made.weight(&product, &weights, external)) {
            Some(weight) => {
                made.product(&node, &weight, &mut nodes);
                count += 1;
            }
            None => nodes.push(node),
        }
    }
    graph.node = nodes;
    graph.initializer.extend(made.tensors);
    drop_unread(graph);
    for tensor in &mut graph.initializer {
        bring_inside(tensor, external)?;
    }
    Ok(count)
}

/// A node that multiplies by a matrix of weights.
struct Product<'n> {
    weight: &'n str,
    transposed: bool,
}

impl<'n> Product<'n> {
    fn of(node: &'n Node) -> Option<Self> {
        let weight = node.input.get(1)?.as_str();
        node.output.first()?;
        let number = |name: &str| node.attribute.iter().find(|attribute| attribute.name() == name);
        let unscaled =
            |name: &str| number(name).is_none_or(|a| a.f.is_none_or(|f| (f - 1.0).abs() < f32::EPSILON));
        let turned = |name: &str| number(name).is_some_and(|attribute: &Attribute| attribute.i() != 0);
        match node.op_type() {
            "MatMul" => Some(Self { weight, transposed: false }),
            "Gemm" if unscaled("alpha") && unscaled("beta") && !turned("transA") => {
                Some(Self { weight, transposed: turned("transB") })
            }
            _ => None,
        }
    }
}

/// Names of a quantised value: numbers, scale, zero point.
type Names = [String; 3];

#[derive(Default)]
struct Made {
    weights: HashMap<(String, bool), Names>,
    inputs: HashMap<String, Names>,
    tensors: Vec<Tensor>,
}

impl Made {
    /// The weights of `product` in eight bits; None where they are no matrix of known 32-bit numbers.
    fn weight(
        &mut self,
        product: &Product,
        weights: &HashMap<String, Tensor>,
        external: &Files,
    ) -> Option<Names> {
        let key = (product.weight.to_owned(), product.transposed);
        if let Some(names) = self.weights.get(&key) {
            return Some(names.clone());
        }
        let tensor = weights.get(product.weight)?;
        let [first, second] = tensor.dims.as_slice() else { return None };
        let (first, second) = (usize::try_from(*first).ok()?, usize::try_from(*second).ok()?);
        let count = first.checked_mul(second).filter(|count| *count > 0);
        let values = floats(tensor, external).filter(|values| Some(values.len()) == count)?;
        let (rows, columns, values) = if product.transposed {
            let turned = (0..second).flat_map(|k| values.iter().skip(k).step_by(second).copied());
            (second, first, turned.collect())
        } else {
            (first, second, values)
        };
        let (scales, numbers) = by_column(&values, columns);
        let suffix = if product.transposed { "_transposed" } else { "" };
        let names =
            ["quantized", "scale", "zero_point"].map(|part| format!("{}{suffix}_{part}", product.weight));
        let shape = [rows as i64, columns as i64];
        self.tensors.push(raw(&names[0], elem::INT8, &shape, bytemuck::cast_slice(&numbers)));
        self.tensors.push(raw(&names[1], elem::FLOAT, &shape[1..], bytemuck::cast_slice(&scales)));
        self.tensors.push(raw(&names[2], elem::INT8, &shape[1..], &vec![0; columns]));
        self.weights.insert(key, names.clone());
        Some(names)
    }

    /// Writes the product of a node anew: in whole numbers, and scaled back.
    fn product(&mut self, node: &Node, weight: &Names, nodes: &mut Vec<Node>) {
        let (input, output) = (&node.input[0], &node.output[0]);
        let fed = self.inputs.entry(input.clone()).or_insert_with(|| {
            let names = ["quantized", "scale", "zero_point"].map(|part| format!("{input}_{part}"));
            let outputs = names.each_ref().map(String::as_str);
            nodes.push(Node::new("DynamicQuantizeLinear", &[input], &outputs, &format!("{input}_quantize")));
            names
        });
        let part = |name: &str| format!("{output}_{name}");
        let (whole, real, scale, scaled) = (part("integer"), part("cast"), part("scales"), part("scaled"));
        let bias = node.input.get(2).filter(|bias| node.op_type() == "Gemm" && !bias.is_empty());
        let product = if bias.is_some() { &scaled } else { output };
        let factors = [fed[0].as_str(), &weight[0], &fed[2], &weight[2]];
        nodes.push(Node::new("MatMulInteger", &factors, &[&whole], &whole));
        nodes.push(Node::cast(&whole, &real, elem::FLOAT));
        nodes.push(Node::new("Mul", &[&fed[1], &weight[1]], &[&scale], &scale));
        nodes.push(Node::new("Mul", &[&real, &scale], &[product], &part("mul")));
        if let Some(bias) = bias {
            nodes.push(Node::new("Add", &[product, bias], &[output], &part("bias")));
        }
    }
}

/// Scales of the columns, and the numbers in units of them, to the nearest and halves to the even.
fn by_column(values: &[f32], columns: usize) -> (Vec<f32>, Vec<i8>) {
    let mut scales = vec![0.0f32; columns];
    for row in values.chunks_exact(columns.max(1)) {
        for (scale, value) in scales.iter_mut().zip(row) {
            *scale = scale.max(value.abs());
        }
    }
    for scale in &mut scales {
        *scale = if *scale > 0.0 { *scale / GREATEST } else { 1.0 };
    }
    let number =
        |(value, scale): (&f32, &f32)| (value / scale).round_ties_even().clamp(-GREATEST, GREATEST) as i8;
    let rows = values.chunks_exact(columns.max(1));
    let numbers = rows.flat_map(|row| row.iter().zip(&scales).map(number)).collect();
    (scales, numbers)
}

/// The numbers of a 32-bit tensor.
fn floats(tensor: &Tensor, external: &Files) -> Option<Vec<f32>> {
    if tensor.data_type() != elem::FLOAT {
        return None;
    }
    match data(tensor, external).ok()? {
        Some(bytes) => Some(bytemuck::pod_collect_to_vec(bytes.get(..bytes.len() / 4 * 4)?)),
        None => Some(tensor.float_data.clone()),
    }
}

/// The bytes of a tensor where they are in one piece, here or in another file.
fn data<'d>(tensor: &'d Tensor, external: &'d Files) -> Result<Option<&'d [u8]>, String> {
    let Some((file, offset, length)) = tensor.external() else { return Ok(tensor.raw_data.as_deref()) };
    let whole = external.iter().find(|(name, _)| name == file).map_or(&[][..], |(_, bytes)| bytes);
    let start = usize::try_from(offset).unwrap_or(usize::MAX);
    let end = length.map_or(whole.len(), |length| start.saturating_add(length as usize));
    match whole.get(start..end) {
        Some(bytes) => Ok(Some(bytes)),
        None => Err(format!("its weights {} are not in {file}", tensor.name())),
    }
}

fn bring_inside(tensor: &mut Tensor, external: &Files) -> Result<(), String> {
    if tensor.external().is_some() {
        let bytes = data(tensor, external)?.map(Bytes::copy_from_slice);
        tensor.raw_data = bytes;
        tensor.external_data.clear();
        tensor.data_location = None;
    }
    Ok(())
}

fn raw(name: &str, data_type: i32, dims: &[i64], bytes: &[u8]) -> Tensor {
    Tensor {
        dims: dims.to_vec(),
        data_type: Some(data_type),
        name: Some(name.to_owned()),
        raw_data: Some(Bytes::copy_from_slice(bytes)),
        ..Tensor::default()
    }
}

/// Drops the weights that nothing reads any more.
fn drop_unread(graph: &mut Graph) {
    let mut read = HashSet::new();
    for node in &graph.node {
        let mut names = Vec::new();
        super::network::names_read(node, &mut names);
        read.extend(names.into_iter().map(str::to_owned));
    }
    read.extend(graph.output.iter().map(|output| output.name().to_owned()));
    graph.initializer.retain(|tensor| read.contains(tensor.name()));
    let kept: HashSet<&str> = graph.initializer.iter().map(Tensor::name).collect();
    let made: HashSet<&str> = graph.node.iter().flat_map(|node| &node.output).map(String::as_str).collect();
    graph.value_info.retain(|value| made.contains(value.name()) || kept.contains(value.name()));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_fills_its_own_range_and_halves_go_to_the_even() {
        let (scales, numbers) = by_column(&[127.0, 0.0, -0.5, 0.0, 2.5, 0.0], 2);
        assert_eq!(scales, [1.0, 1.0]);
        assert_eq!(numbers, [127, 0, 0, 0, 2, 0]);
        let (scales, numbers) = by_column(&[-1.0, 2.0, 0.25, -8.0], 2);
        assert_eq!(scales, [1.0 / 127.0, 8.0 / 127.0]);
        assert_eq!(numbers, [-127, 32, 32, -127]);
    }
}
