// SPDX-License-Identifier: MIT OR Apache-2.0
//! The hub's protocol: what is known of a file, and its bytes from some place on.
//!
//! Requests run on threads of their own and hand over what comes, so that whoever waits for a silent server
//! can be cancelled at once. Such a thread writes nothing, and ends when nobody listens or time is up.

use std::io::Read;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::time::Duration;

use ureq::http::{HeaderMap, Uri};
use ureq::tls::{RootCerts, TlsConfig};
use ureq::{Agent, Body, Proxy};

use super::HubError;
use super::endpoint::{self, host, is_safe};
use super::failure;
use super::hash::Hash;
use super::proxy::proxy_for;
use super::wanted::Wanted;

/// Redirects that are followed; the hub needs two.
const MOST_REDIRECTS: usize = 8;

/// Bytes handed over at once, and how many such pieces may wait for the disk.
const PIECE: usize = 256 << 10;
const PIECES: usize = 16;

/// How often a waiting thread looks whether it is cancelled.
const LOOK: Duration = Duration::from_millis(50);

/// Says whether the work is to stop.
pub type Cancelled<'a> = &'a dyn Fn() -> bool;

/// What the hub says of a file.
#[derive(Debug, Clone, Default)]
pub struct Meta {
    pub commit: Option<String>,
    pub hash: Option<Hash>,
    pub bytes: Option<u64>,
}

/// What comes of a file.
pub enum Event {
    /// The place in the file from which on its bytes come.
    Begins(u64),
    /// Some of its bytes.
    Bytes(Vec<u8>),
}

/// A client of the hub.
#[derive(Clone)]
pub struct Client {
    agent: Agent,
    patience: Duration,
}

type Response = ureq::http::Response<Body>;

impl Client {
    /// A client that waits for `patience` until something comes.
    pub fn new(patience: Duration) -> Self {
        let provider = Arc::new(rustls::crypto::ring::default_provider());
        let tls = TlsConfig::builder()
            .root_certs(RootCerts::PlatformVerifier)
            .unversioned_rustls_crypto_provider(provider)
            .build();
        let config = Agent::config_builder()
            .tls_config(tls)
            .proxy(None)
            .http_status_as_error(false)
            .max_redirects(0)
            .max_redirects_will_error(false)
            .user_agent(concat!("boxmorph/", env!("CARGO_PKG_VERSION")))
            // Compressed, a file would have another length and no places to go on from.
            .accept_encoding("identity")
            .timeout_resolve(Some(patience))
            .timeout_connect(Some(patience))
            .timeout_send_request(Some(patience))
            .timeout_recv_response(Some(patience))
            .timeout_per_read(Some(patience))
            .build();
        Self { agent: config.new_agent(), patience }
    }

    /// What the hub says of a file; none where it has none of this name.
    pub fn meta(&self, wanted: &Wanted, cancelled: Cancelled) -> Result<Option<Meta>, HubError> {
        let (sender, events) = sync_channel(1);
        let (client, wanted) = (self.clone(), wanted.clone());
        spawn(move || {
            let _ = sender.send(client.ask(&wanted));
        })?;
        wait(&events, cancelled)?.unwrap_or_else(|| Err(HubError::Fault("no answer was handed over".into())))
    }

    /// The bytes of a file from `offset` on.
    pub fn bytes(&self, wanted: &Wanted, offset: u64) -> Result<Stream, HubError> {
        let (sender, events) = sync_channel(PIECES);
        let (client, wanted) = (self.clone(), wanted.clone());
        spawn(move || {
            if let Err(error) = client.read(&wanted, offset, &sender) {
                let _ = sender.send(Err(error));
            }
        })?;
        Ok(Stream { events })
    }

    fn ask(&self, wanted: &Wanted) -> Result<Option<Meta>, HubError> {
        let mut meta = Meta::default();
        let mut linked = false;
        let mut address = wanted.address.clone();
        for _ in 0..=MOST_REDIRECTS {
            let response = self.hop(true, &address, None)?;
            let (status, headers) = (response.status().as_u16(), response.headers());
            meta.commit = meta.commit.or_else(|| text(headers, "x-repo-commit"));
            // A large file lies elsewhere: these headers are the hub's own word on it.
            if let Some(hash) = text(headers, "x-linked-etag").and_then(|tag| Hash::from_etag(&tag)) {
                (meta.hash, linked) = (Some(hash), true);
            }
            meta.bytes = number(headers, "x-linked-size").or(meta.bytes);
            if let Some(next) = next_address(&address, status, headers)? {
                if linked && meta.bytes.is_some() && !endpoint::is_same_server(&address, &next) {
                    return Ok(Some(meta));
                }
                address = next;
                continue;
            }
            if status == 404 {
                return Ok(None);
            }
            failure::of_status(status, headers, &host(&address), wanted)?;
            if !linked {
                meta.hash = text(headers, "etag").and_then(|tag| Hash::from_etag(&tag));
            }
            meta.bytes = meta.bytes.or_else(|| number(headers, "content-length"));
            return Ok(Some(meta));
        }
        Err(HubError::Redirects { host: host(&wanted.address) })
    }

    fn read(
        &self,
        wanted: &Wanted,
        offset: u64,
        sender: &SyncSender<Result<Event, HubError>>,
    ) -> Result<(), HubError> {
        let (mut response, host) = self.follow(wanted, offset)?;
        if response.status().as_u16() == 416 {
            // The file ends before.
            return Err(HubError::WrongHash { file: wanted.file.clone(), host });
        }
        failure::of_status(response.status().as_u16(), response.headers(), &host, wanted)?;
        let begins = if response.status().as_u16() == 206 { first_byte(response.headers()) } else { Some(0) };
        let reason = "it sends another part of the file than was asked for";
        let begins = begins
            .filter(|&begins| begins == 0 || begins == offset)
            .ok_or_else(|| HubError::Protocol { host: host.clone(), reason: reason.into() })?;
        if sender.send(Ok(Event::Begins(begins))).is_err() {
            return Ok(());
        }
        let mut reader = response.body_mut().as_reader();
        loop {
            let mut piece = vec![0; PIECE];
            let count = reader
                .read(&mut piece)
                .map_err(|error| failure::of_request(error.into(), &host, self.patience))?;
            piece.truncate(count);
            if count == 0 || sender.send(Ok(Event::Bytes(piece))).is_err() {
                return Ok(());
            }
        }
    }

    /// The answer to a request for a file from `offset` on, where all redirects end, and the host that gives it.
    fn follow(&self, wanted: &Wanted, offset: u64) -> Result<(Response, String), HubError> {
        let mut address = wanted.address.clone();
        for _ in 0..=MOST_REDIRECTS {
            let response = self.hop(false, &address, (offset > 0).then_some(offset))?;
            let next = next_address(&address, response.status().as_u16(), response.headers())?;
            let Some(next) = next else {
                return Ok((response, host(&address)));
            };
            address = next;
        }
        Err(HubError::Redirects { host: host(&wanted.address) })
    }

    /// One request, without following where it leads to.
    fn hop(&self, head: bool, address: &str, offset: Option<u64>) -> Result<Response, HubError> {
        let uri: Uri = address.parse().map_err(|_| HubError::Protocol {
            host: host(address),
            reason: "it redirects to no address".into(),
        })?;
        let host = uri.host().unwrap_or_default().to_owned();
        let named = proxy_for(uri.scheme_str().unwrap_or_default(), &host, |name| std::env::var(name).ok());
        let proxy = named
            .map(|named| Proxy::new(&named).map_err(|_| HubError::BadProxy(named.clone())))
            .transpose()?;
        let request = if head { self.agent.head(uri) } else { self.agent.get(uri) };
        let mut request = request.config().proxy(proxy).build();
        if let Some(offset) = offset {
            request = request.header("Range", format!("bytes={offset}-"));
        }
        request.call().map_err(|error| failure::of_request(error, &host, self.patience))
    }
}

/// The bytes of a file as they come.
pub struct Stream {
    events: Receiver<Result<Event, HubError>>,
}

impl Stream {
    /// What comes next; none at the end.
    pub fn next(&self, cancelled: Cancelled) -> Result<Option<Event>, HubError> {
        wait(&self.events, cancelled)?.transpose()
    }
}

/// What comes next, none once the other side has ended.
fn wait<T>(events: &Receiver<T>, cancelled: Cancelled) -> Result<Option<T>, HubError> {
    loop {
        if cancelled() {
            return Err(HubError::Cancelled);
        }
        match events.recv_timeout(LOOK) {
            Ok(event) => return Ok(Some(event)),
            Err(RecvTimeoutError::Disconnected) => return Ok(None),
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

fn spawn(work: impl FnOnce() + Send + 'static) -> Result<(), HubError> {
    let spawned = std::thread::Builder::new().name("boxmorph-hub".into()).spawn(work);
    spawned.map(drop).map_err(|error| HubError::Thread(error.to_string()))
}

/// The address that a redirect leads to; none where the answer is no redirect.
fn next_address(address: &str, status: u16, headers: &HeaderMap) -> Result<Option<String>, HubError> {
    if !matches!(status, 301 | 302 | 303 | 307 | 308) {
        return Ok(None);
    }
    let next = text(headers, "location").and_then(|location| endpoint::redirected(address, &location));
    let next = next.ok_or_else(|| HubError::Protocol {
        host: host(address),
        reason: "it redirects to no address".into(),
    })?;
    if next.parse::<Uri>().is_ok_and(|uri| is_safe(&uri)) {
        Ok(Some(next))
    } else {
        Err(HubError::NotEncrypted { host: host(address), target: host(&next) })
    }
}

/// The first byte of `Content-Range: bytes 100-199/200`.
fn first_byte(headers: &HeaderMap) -> Option<u64> {
    let range = text(headers, "content-range")?;
    range.trim().strip_prefix("bytes")?.trim_start().split_once('-')?.0.parse().ok()
}

fn text(headers: &HeaderMap, name: &str) -> Option<String> {
    headers.get(name)?.to_str().ok().map(str::to_owned)
}

fn number(headers: &HeaderMap, name: &str) -> Option<u64> {
    text(headers, name)?.trim().parse().ok()
}
