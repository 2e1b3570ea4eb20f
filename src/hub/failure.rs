// SPDX-License-Identifier: MIT OR Apache-2.0
//! From what the network and a server say to a sentence.

use std::io::{self, ErrorKind};
use std::time::Duration;

use ureq::http::HeaderMap;

use super::HubError;
use super::wanted::Wanted;

/// How long a server that names no time is left alone.
const USUAL_WAIT: Duration = Duration::from_secs(30);

/// What a status that is no success means.
pub fn of_status(status: u16, headers: &HeaderMap, host: &str, wanted: &Wanted) -> Result<(), HubError> {
    let (host, file, repository) = (host.to_owned(), wanted.file.clone(), wanted.repository.clone());
    Err(match status {
        200 | 206 => return Ok(()),
        401 | 403 => HubError::Forbidden { host, file, repository, status },
        404 | 410 => HubError::NotFound { host, file, repository },
        429 => HubError::TooMany { host, wait: retry_after(headers).unwrap_or(USUAL_WAIT) },
        408 | 500..=599 => HubError::Server { host, status },
        _ => HubError::Status { host, file, status },
    })
}

/// What a request that got no answer, or lost it, means.
pub fn of_request(error: ureq::Error, host: &str, patience: Duration) -> HubError {
    let host = host.to_owned();
    match error {
        ureq::Error::HostNotFound => HubError::NoName { host },
        ureq::Error::Timeout(_) => HubError::Timeout { host, after: patience },
        ureq::Error::Io(error) => of_io(&error, host, patience),
        ureq::Error::ConnectProxyFailed(reason) => HubError::Proxy { host, reason },
        ureq::Error::Tls(reason) => HubError::Tls { host, reason: reason.into() },
        ureq::Error::Rustls(error) => HubError::Tls { host, reason: error.to_string() },
        ureq::Error::ConnectionFailed => HubError::NoConnection { host, reason: "it is refused".into() },
        // A connection that ends within the headers.
        error @ (ureq::Error::Protocol(_) | ureq::Error::BodyStalled) => {
            HubError::Cut { host, reason: error.to_string() }
        }
        error => HubError::Protocol { host, reason: error.to_string() },
    }
}

fn of_io(error: &io::Error, host: String, patience: Duration) -> HubError {
    let inner = error.get_ref();
    if let Some(tls) = inner.and_then(|inner| inner.downcast_ref::<rustls::Error>()) {
        return HubError::Tls { host, reason: tls.to_string() };
    }
    match error.kind() {
        ErrorKind::TimedOut | ErrorKind::WouldBlock => HubError::Timeout { host, after: patience },
        ErrorKind::UnexpectedEof
        | ErrorKind::ConnectionReset
        | ErrorKind::ConnectionAborted
        | ErrorKind::BrokenPipe => HubError::Cut { host, reason: error.to_string() },
        _ if is_no_name(error) => HubError::NoName { host },
        _ => HubError::NoConnection { host, reason: error.to_string() },
    }
}

/// Whether a name was not resolved: the standard library has no kind for that.
fn is_no_name(error: &io::Error) -> bool {
    /// `WSAHOST_NOT_FOUND` to `WSANO_DATA`.
    const WINDOWS: std::ops::RangeInclusive<i32> = 11001..=11004;
    error.raw_os_error().is_some_and(|code| cfg!(windows) && WINDOWS.contains(&code))
        || error.to_string().starts_with("failed to lookup address information")
}

/// The seconds that a server wants to be left alone; a date there is not read.
fn retry_after(headers: &HeaderMap) -> Option<Duration> {
    headers.get("retry-after")?.to_str().ok()?.trim().parse().ok().map(Duration::from_secs)
}
