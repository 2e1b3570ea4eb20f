// SPDX-License-Identifier: MIT OR Apache-2.0
//! What stands before a vision network inside its graph: views with alpha become images before backgrounds,
//! normalised as the network wants them.
//!
//! A pixel of an image is linear in the pixel of its view: `mix · (r, g, b, α) + base`, with premultiplied colors.
//! One product of small matrices thus composites and normalises, and lays channels out as planes; a view before
//! three backgrounds is handed over once.

use prost::Message;

use super::GuideError;
use super::network::{Network, decode};
use super::onnx::{Attribute, Graph, Node, Shape, Tensor, TensorType, Type, ValueInfo, elem};

/// Bytes of the views: v × pixels × 4, premultiplied RGBA.
pub const VIEWS: &str = "boxmorph/views";
/// What each channel takes of a view's: v × 3 m × 4, for m images of each view.
pub const MIX: &str = "boxmorph/mix";
/// What is added to each channel: v × 3 m × 1.
pub const BASE: &str = "boxmorph/base";

/// `AttributeProto.AttributeType` of tensors and of lists of numbers.
const TENSOR: i32 = 4;
const INTS: i32 = 7;

/// The network, reading views: for images of `size` × `size` pixels.
pub fn extend(network: &Network, size: u32) -> Result<Network, GuideError> {
    let bad = |reason: String| GuideError::BadModel { file: network.file.clone(), reason };
    let mut model = decode(&network.file, &network.model)?;
    put_before(model.graph.get_or_insert_default(), size).map_err(bad)?;
    Ok(Network { model: model.encode_to_vec().into(), ..network.clone() })
}

/// Replaces the image input of a graph by the prologue's.
fn put_before(graph: &mut Graph, size: u32) -> Result<(), String> {
    let is_weight = |input: &ValueInfo| graph.initializer.iter().any(|weight| weight.name() == input.name());
    let is_image = |input: &ValueInfo| input.shape().is_none_or(|shape| shape.len() == 4);
    let place = graph.input.iter().position(|input| is_image(input) && !is_weight(input));
    let input = graph.input.remove(place.ok_or("it has no input for images")?);
    let kind = input.elem_type().ok_or("its input is no tensor")?;
    if ![elem::FLOAT, elem::FLOAT16, elem::BFLOAT16, elem::DOUBLE].contains(&kind) {
        return Err(format!("its input {} holds numbers of a kind that no guide reads", input.name()));
    }
    let side = i64::from(size);
    graph.input.extend([
        value(VIEWS, elem::UINT8, [None, Some(side * side), Some(4)]),
        value(MIX, elem::FLOAT, [None, None, Some(4)]),
        value(BASE, elem::FLOAT, [None, None, Some(1)]),
    ]);
    let [planes, real, mixed, based, shape, images] =
        ["planes", "real", "mixed", "based", "shape", "images"].map(|name| format!("boxmorph/{name}"));
    let last = if kind == elem::FLOAT { input.name() } else { images.as_str() };
    let mut nodes = vec![
        // Bytes are turned round, a quarter of what real numbers would be.
        with(Node::new("Transpose", &[VIEWS], &[&planes], &planes), "perm", INTS, |perm| {
            perm.ints = vec![0, 2, 1];
        }),
        Node::cast(&planes, &real, elem::FLOAT),
        Node::new("MatMul", &[MIX, &real], &[&mixed], &mixed),
        Node::new("Add", &[&mixed, BASE], &[&based], &based),
        // Not an initializer, which old models would have to list among their inputs.
        with(Node::new("Constant", &[], &[&shape], &shape), "value", TENSOR, |value| {
            let int64_data = vec![-1, 3, side, side];
            let data_type = Some(elem::INT64);
            value.t = Some(Tensor { dims: vec![4], data_type, int64_data, ..Tensor::default() });
        }),
        Node::new("Reshape", &[&based, &shape], &[last], "boxmorph/reshape"),
    ];
    if kind != elem::FLOAT {
        nodes.push(Node::cast(&images, input.name(), kind));
    }
    graph.node.splice(0..0, nodes);
    Ok(())
}

fn with(mut node: Node, name: &str, kind: i32, fill: impl Fn(&mut Attribute)) -> Node {
    let mut attribute = Attribute { name: Some(name.into()), r#type: Some(kind), ..Attribute::default() };
    fill(&mut attribute);
    node.attribute.push(attribute);
    node
}

/// An input with axes of the lengths given, or free.
fn value(name: &str, kind: i32, lengths: [Option<i64>; 3]) -> ValueInfo {
    let dim = lengths.map(|dim_value| super::onnx::Dimension { dim_value, ..Default::default() }).to_vec();
    let tensor_type = Some(TensorType { elem_type: Some(kind), shape: Some(Shape { dim }) });
    let r#type = Some(Type { tensor_type, ..Type::default() });
    ValueInfo { name: Some(name.into()), r#type, ..ValueInfo::default() }
}
