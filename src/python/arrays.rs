// SPDX-License-Identifier: MIT OR Apache-2.0
//! `NumPy` arrays to slices of vectors and back.

use glam::Vec3;
use numpy::{
    Element, PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;

/// A C-contiguous array of `columns` columns and dtype `T`, flattened.
///
/// A wrong dtype is a `TypeError`; a wrong shape or memory order a `ValueError`.
fn flat<'py, T: Element>(
    value: &Bound<'py, PyAny>,
    name: &str,
    kind: &str,
) -> PyResult<PyReadonlyArrayDyn<'py, T>> {
    let array = value
        .cast::<PyArrayDyn<T>>()
        .map_err(|_| PyTypeError::new_err(format!("{name} must be a numpy array of {kind}")))?;
    // A Fortran-ordered array would come out transposed.
    if !array.is_c_contiguous() {
        return Err(PyValueError::new_err(format!(
            "{name} must be C-contiguous; pass numpy.ascontiguousarray({name})"
        )));
    }
    Ok(array.readonly())
}

fn check_columns(shape: &[usize], columns: usize, name: &str) -> PyResult<()> {
    if shape.len() == 2 && shape[1] == columns {
        return Ok(());
    }
    Err(PyValueError::new_err(format!("{name} must have the shape (n, {columns}), not {shape:?}")))
}

/// An `(n, 3)` float32 array.
pub fn vectors(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<Vec3>> {
    let array = flat::<f32>(value, name, "float32")?;
    check_columns(array.shape(), 3, name)?;
    Ok(bytemuck::cast_slice(array.as_slice()?).iter().map(|v: &[f32; 3]| Vec3::from_array(*v)).collect())
}

/// An `(m, 3)` uint32 or int32 array of indices; a negative index becomes one that no mesh has.
pub fn triangles(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<[u32; 3]>> {
    if let Ok(array) = flat::<u32>(value, name, "uint32 or int32") {
        check_columns(array.shape(), 3, name)?;
        return Ok(bytemuck::cast_slice(array.as_slice()?).to_vec());
    }
    let array = flat::<i32>(value, name, "uint32 or int32")?;
    check_columns(array.shape(), 3, name)?;
    let index = |i: i32| u32::try_from(i).unwrap_or(u32::MAX);
    Ok(bytemuck::cast_slice(array.as_slice()?).iter().map(|t: &[i32; 3]| t.map(index)).collect())
}

/// An `(n,)` array of any integer dtype up to 64 bits, such as the reference data's int8 and int16.
pub fn integers(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<i32>> {
    flat_integers(value, name, 1)
}

/// An `(n, 3)` bool array.
pub fn flags(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<[bool; 3]>> {
    let array = flat::<bool>(value, name, "bool")?;
    check_columns(array.shape(), 3, name)?;
    Ok(array.as_slice()?.chunks_exact(3).map(|row| [row[0], row[1], row[2]]).collect())
}

/// An `(m, 3)` uint8 array.
pub fn colors(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<[u8; 3]>> {
    let array = flat::<u8>(value, name, "uint8")?;
    check_columns(array.shape(), 3, name)?;
    Ok(bytemuck::cast_slice(array.as_slice()?).to_vec())
}

/// An `(n, 2)` array of any integer dtype.
pub fn pairs(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<[i32; 2]>> {
    let flat = flat_integers(value, name, 2)?;
    Ok(flat.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect())
}

fn flat_integers(value: &Bound<'_, PyAny>, name: &str, dimensions: usize) -> PyResult<Vec<i32>> {
    let kind = value.getattr("dtype").and_then(|dtype| dtype.getattr("kind")?.extract::<String>());
    if !matches!(kind.as_deref(), Ok("i" | "u")) {
        return Err(PyTypeError::new_err(format!("{name} must be a numpy array of integers")));
    }
    let as_i32 = value.call_method1("astype", ("int32", "C"))?;
    let array = flat::<i32>(&as_i32, name, "integers")?;
    if array.shape().len() != dimensions || (dimensions == 2 && array.shape()[1] != 2) {
        let wanted = if dimensions == 1 { "(n,)" } else { "(n, 2)" };
        return Err(PyValueError::new_err(format!(
            "{name} must have the shape {wanted}, not {:?}",
            array.shape()
        )));
    }
    Ok(array.as_slice()?.to_vec())
}

/// A `(k, h, w, 3)` uint8 array of square images of `size` pixels.
pub fn images(value: &Bound<'_, PyAny>, size: usize) -> PyResult<Vec<u8>> {
    let array = flat::<u8>(value, "images", "uint8")?;
    let shape = array.shape();
    if shape.len() != 4 || shape[1..] != [size, size, 3] {
        return Err(PyValueError::new_err(format!(
            "images must have the shape (k, {size}, {size}, 3), not {shape:?}; render at guide.image_size"
        )));
    }
    Ok(array.as_slice()?.to_vec())
}

/// Vectors as an `(n, 3)` float32 array.
pub fn from_vectors<'py>(py: Python<'py>, vectors: &[Vec3]) -> PyResult<Bound<'py, PyArray2<f32>>> {
    let numbers = vectors.iter().flat_map(Vec3::to_array).collect();
    PyArray1::from_vec(py, numbers).reshape([vectors.len(), 3])
}

/// Pairs as an `(n, 2)` int32 array.
pub fn from_pairs<'py>(py: Python<'py>, pairs: &[[i32; 2]]) -> PyResult<Bound<'py, PyArray2<i32>>> {
    PyArray1::from_vec(py, pairs.concat()).reshape([pairs.len(), 2])
}
