// SPDX-License-Identifier: MIT OR Apache-2.0
//! Buffers that outlive the task that fills them.

use std::sync::{Mutex, PoisonError};

/// Buffers that tasks take and give back: as many as there are tasks at a time, each as large as it ever was.
#[derive(Debug, Default)]
pub struct Spare<T>(Mutex<Vec<T>>);

impl<T: Default> Spare<T> {
    /// Does `work` with a buffer, whose content is that of its last use.
    pub fn with<R>(&self, work: impl FnOnce(&mut T) -> R) -> R {
        let mut item = self.0.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default();
        let result = work(&mut item);
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(item);
        result
    }
}
