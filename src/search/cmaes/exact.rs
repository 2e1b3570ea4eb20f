// SPDX-License-Identifier: MIT OR Apache-2.0
//! Serde for floating-point numbers that come back to the bit, whatever the format.
//!
//! JSON has no infinities, and its common parsers round the last bit; numbers therefore travel as text,
//! in the shortest form that reads back to the same bits. Use as `#[serde(with = "exact")]`.

use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::DeserializeOwned, de::Error};

/// A value made of `f64` that can travel as text.
pub(super) trait Exact: Sized {
    /// What travels.
    type Text: Serialize + DeserializeOwned;
    fn text(&self) -> Self::Text;
    fn parse(text: Self::Text) -> Option<Self>;
}

pub(super) fn serialize<T: Exact, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    value.text().serialize(serializer)
}

pub(super) fn deserialize<'de, T: Exact, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    T::parse(T::Text::deserialize(deserializer)?).ok_or_else(|| D::Error::custom("not a number"))
}

impl Exact for f64 {
    type Text = String;
    fn text(&self) -> String {
        format!("{self:?}")
    }
    fn parse(text: String) -> Option<Self> {
        text.parse().ok()
    }
}

impl<A: Exact, B: Exact> Exact for (A, B) {
    type Text = (A::Text, B::Text);
    fn text(&self) -> Self::Text {
        (self.0.text(), self.1.text())
    }
    fn parse(text: Self::Text) -> Option<Self> {
        Some((A::parse(text.0)?, B::parse(text.1)?))
    }
}

impl<T: Exact> Exact for Vec<T> {
    type Text = Vec<T::Text>;
    fn text(&self) -> Self::Text {
        self.iter().map(Exact::text).collect()
    }
    fn parse(text: Self::Text) -> Option<Self> {
        text.into_iter().map(T::parse).collect()
    }
}

impl<T: Exact> Exact for Option<T> {
    type Text = Option<T::Text>;
    fn text(&self) -> Self::Text {
        self.as_ref().map(Exact::text)
    }
    fn parse(text: Self::Text) -> Option<Self> {
        text.map_or(Some(None), |text| T::parse(text).map(Some))
    }
}

impl Exact for DVector<f64> {
    type Text = Vec<String>;
    fn text(&self) -> Self::Text {
        self.iter().map(Exact::text).collect()
    }
    fn parse(text: Self::Text) -> Option<Self> {
        Vec::parse(text).map(DVector::from_vec)
    }
}

/// Square, column by column.
impl Exact for DMatrix<f64> {
    type Text = Vec<String>;
    fn text(&self) -> Self::Text {
        self.iter().map(Exact::text).collect()
    }
    fn parse(text: Self::Text) -> Option<Self> {
        let side = text.len().isqrt();
        let square = side * side == text.len();
        Vec::parse(text).filter(|_| square).map(|values| DMatrix::from_vec(side, side, values))
    }
}
