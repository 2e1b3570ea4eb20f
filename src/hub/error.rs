// SPDX-License-Identifier: MIT OR Apache-2.0
//! What can go wrong on the way from the hub to a folder.

use std::io::{self, ErrorKind};
use std::path::Path;
use std::time::Duration;

use thiserror::Error;

/// Why a guide is not there. Cheap to clone: it is reported each time the result is asked for.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum HubError {
    /// The user cancelled.
    #[error("the download was cancelled; what has come is kept, and the next download goes on from there")]
    Cancelled,
    /// `start` was called twice.
    #[error("this download was started before; make a new one to go on")]
    AlreadyStarted,
    /// `result` was called too early.
    #[error("the download has not finished; call start() and join() first")]
    NotFinished,
    /// No thread could be had.
    #[error("no thread could be started for the download ({0}); close other programs and try again")]
    Thread(String),
    /// The download broke for a reason that is not the user's.
    #[error("the download stopped for a fault of its own ({0}); please report it")]
    Fault(String),
    /// No guide has this name.
    #[error("there is no guide \"{id}\" to download; choose {known}")]
    UnknownGuide {
        /// The name given.
        id: String,
        /// Those there are.
        known: String,
    },
    /// The guide does not come in this precision.
    #[error("the guide \"{id}\" does not come in {precision}; choose {known}")]
    UnknownPrecision {
        /// The guide.
        id: String,
        /// The precision given.
        precision: String,
        /// Those there are.
        known: String,
    },
    /// The hub's address is none.
    #[error("\"{address}\" is no address of a hub ({reason}); write one such as https://huggingface.co")]
    BadEndpoint {
        /// The address given.
        address: String,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// An answer leads to a connection that anyone may read and change.
    #[error(
        "{host} redirects to {target}, which is not encrypted; nothing was taken from there. Use another hub address"
    )]
    NotEncrypted {
        /// Who redirects.
        host: String,
        /// Where to.
        target: String,
    },
    /// The proxy's address is none.
    #[error("\"{0}\", which the environment names as proxy, is no address; correct HTTPS_PROXY or clear it")]
    BadProxy(String),
    /// The proxy does not let us through.
    #[error(
        "the proxy does not connect to {host} ({reason}); check HTTPS_PROXY, or add the host to NO_PROXY"
    )]
    Proxy {
        /// The host wanted.
        host: String,
        /// What it says.
        reason: String,
    },
    /// The name has no address.
    #[error("the name {host} cannot be resolved; check the network, or the hub's address")]
    NoName {
        /// The host wanted.
        host: String,
    },
    /// A connection that broke off.
    #[error(
        "the connection to {host} broke off ({reason}); check the network and try again: it goes on from where it is"
    )]
    Cut {
        /// The host.
        host: String,
        /// What the system says.
        reason: String,
    },
    /// No connection.
    #[error(
        "there is no connection to {host} ({reason}); check the network and try again: it goes on from where it is"
    )]
    NoConnection {
        /// The host wanted.
        host: String,
        /// What the system says.
        reason: String,
    },
    /// Nothing came for too long.
    #[error("{host} was silent for {} s; try again later: it goes on from where it is", .after.as_secs_f32())]
    Timeout {
        /// The host.
        host: String,
        /// How long it was waited for.
        after: Duration,
    },
    /// The connection is not trusted.
    #[error(
        "the encrypted connection to {host} is not trusted ({reason}); check the system's date and certificates"
    )]
    Tls {
        /// The host.
        host: String,
        /// What is wrong.
        reason: String,
    },
    /// The server wants to know who asks.
    #[error(
        "{host} gives {file} of {repository} to members only (status {status}); accept its terms there and download it by hand, or choose another guide"
    )]
    Forbidden {
        /// The host.
        host: String,
        /// The file.
        file: String,
        /// The repository.
        repository: String,
        /// 401 or 403.
        status: u16,
    },
    /// There is no such file.
    #[error(
        "{host} has no {file} in {repository}; choose another precision or guide, or check the hub's address"
    )]
    NotFound {
        /// The host.
        host: String,
        /// The file.
        file: String,
        /// The repository.
        repository: String,
    },
    /// The server wants fewer requests.
    #[error("{host} takes no more requests for now (status 429); try again in {} min: it goes on from where it is", .wait.as_secs().div_ceil(60).max(1))]
    TooMany {
        /// The host.
        host: String,
        /// How long it wants to be left alone.
        wait: Duration,
    },
    /// The server is out of order.
    #[error("{host} is out of order (status {status}); try again later: it goes on from where it is")]
    Server {
        /// The host.
        host: String,
        /// The status.
        status: u16,
    },
    /// Anything else that is no file.
    #[error("{host} answers the request for {file} with status {status}; check the hub's address")]
    Status {
        /// The host.
        host: String,
        /// The file.
        file: String,
        /// The status.
        status: u16,
    },
    /// Redirects without end.
    #[error("{host} redirects without end; check the hub's address")]
    Redirects {
        /// The host.
        host: String,
    },
    /// An answer that is not of the hub's protocol.
    #[error("{host} does not answer as a hub does ({reason}); check the hub's address")]
    Protocol {
        /// The host.
        host: String,
        /// What is wrong.
        reason: String,
    },
    /// What came is not what was announced.
    #[error(
        "{file} arrived damaged (it is not the file that {host} announces); it was deleted. Try again, or use another hub address"
    )]
    WrongHash {
        /// The file.
        file: String,
        /// The host.
        host: String,
    },
    /// The server announces another file than the one we know.
    #[error(
        "{host} announces another {file} than the one that is known; nothing was taken. Use another hub address"
    )]
    OtherFile {
        /// The file.
        file: String,
        /// The host.
        host: String,
    },
    /// The disk is too full to begin.
    #[error("there is no room in {folder}: {} more are needed, {} are free. Free some, or name another guides folder", megabytes(*.needed), megabytes(*.free))]
    NoSpace {
        /// The guides folder.
        folder: String,
        /// Bytes still to come, and some to stay free.
        needed: u64,
        /// Bytes free.
        free: u64,
    },
    /// The disk, or the user's share of it, became full on the way.
    #[error("{folder} took no more ({reason}); {} are still to come. Make room there and download again: it goes on from where it is. Or name another guides folder", megabytes(*.needed))]
    Full {
        /// The guides folder.
        folder: String,
        /// What the system says.
        reason: String,
        /// Bytes still to come.
        needed: u64,
    },
    /// The folder does not take files.
    #[error("{path} cannot be written ({reason}); check its permissions, or name another guides folder")]
    Folder {
        /// The file or folder.
        path: String,
        /// What the system says.
        reason: String,
    },
    /// Something else lies where the guide should.
    #[error("{0} is there already and was not made by a download; rename or remove it first")]
    Exists(String),
    /// Another process downloads the same guide.
    #[error("another Blender downloads this guide into {0} already; wait for it")]
    Busy(String),
}

impl HubError {
    /// Whether trying again soon may help.
    pub(super) fn is_transient(&self) -> bool {
        match self {
            Self::NoName { .. }
            | Self::NoConnection { .. }
            | Self::Cut { .. }
            | Self::Timeout { .. }
            | Self::Server { .. } => true,
            Self::TooMany { wait, .. } => *wait <= super::LONGEST_WAIT,
            _ => false,
        }
    }

    /// The error of a file or folder that cannot be made or written.
    pub(super) fn folder(path: &Path, error: &io::Error) -> Self {
        let (path, reason) = (path.display().to_string(), error.to_string());
        match error.kind() {
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => {
                Self::Full { folder: path, reason, needed: 0 }
            }
            _ => Self::Folder { path, reason },
        }
    }

    /// Of a disk that became full: the guides folder, and how much is still to come.
    pub(super) fn of_guide(self, root: &Path, missing: u64) -> Self {
        match self {
            Self::Full { reason, .. } => {
                Self::Full { folder: root.display().to_string(), reason, needed: missing }
            }
            other => other,
        }
    }
}

fn megabytes(bytes: u64) -> String {
    format!("{} MB", bytes.div_ceil(1_000_000))
}
