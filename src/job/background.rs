// SPDX-License-Identifier: MIT OR Apache-2.0
//! The threads that jobs work on. They give way to those that draw the interface: a viewport stays smooth while
//! a search takes all cores, and a search alone on the machine is as fast as ever.

use std::sync::OnceLock;

use rayon::{ThreadPool, ThreadPoolBuilder};
use thread_priority::{ThreadPriority, ThreadPriorityValue, set_current_thread_priority};

/// Of 100: niceness 15 on Linux, `LOWEST` on Windows. Less would not leave the viewport half of its redraws on two cores.
const SHARE: u8 = 10;

static POOL: OnceLock<Option<ThreadPool>> = OnceLock::new();

/// Does `work` on the threads of jobs, on which its parallel loops run too. Waits for its end.
pub fn in_background<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    let pool = POOL.get_or_init(|| {
        let threads = ThreadPoolBuilder::new().thread_name(|index| format!("boxmorph-job-{index}"));
        threads.start_handler(|_| give_way()).build().ok()
    });
    match pool {
        Some(pool) => pool.install(work),
        None => work(),
    }
}

/// Lowers the priority of this thread. Where the system forbids it, the work is done all the same.
fn give_way() {
    let share = ThreadPriorityValue::try_from(SHARE).map(ThreadPriority::Crossplatform);
    let _ = share.map(set_current_thread_priority);
}
