// SPDX-License-Identifier: MIT OR Apache-2.0
//! Addresses: of the hub, of its files, and of where it redirects to.

use ureq::http::Uri;

use super::HubError;

/// The hub itself.
const DEFAULT: &str = "https://huggingface.co";

/// Names another hub, as it does for other programs.
const VARIABLE: &str = "HF_ENDPOINT";

/// The address of a hub, without a slash at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct Endpoint(String);

impl Endpoint {
    /// The hub that was asked for, else that of the environment, else the usual one. Only on this machine may
    /// it be without encryption.
    pub fn new(asked: Option<&str>) -> Result<Self, HubError> {
        let asked = asked.map(str::trim).filter(|address| !address.is_empty()).map(str::to_owned);
        let address = asked
            .or_else(|| std::env::var(VARIABLE).ok().filter(|address| !address.trim().is_empty()))
            .unwrap_or_else(|| DEFAULT.into());
        let address = address.trim().trim_end_matches('/').to_owned();
        let bad = |reason| HubError::BadEndpoint { address: address.clone(), reason };
        let uri: Uri = address.parse().map_err(|_| bad("it cannot be read"))?;
        if uri.host().is_none_or(str::is_empty) || !matches!(uri.scheme_str(), Some("http" | "https")) {
            return Err(bad("it begins neither with https:// nor with http://"));
        }
        if uri.query().is_some() || uri.authority().is_some_and(|authority| authority.as_str().contains('@'))
        {
            return Err(bad("it holds more than a host and a path"));
        }
        if !is_safe(&uri) {
            return Err(bad("http is for this machine alone; elsewhere it must be https"));
        }
        Ok(Self(address))
    }

    /// The address of a file.
    pub fn file(&self, repository: &str, revision: &str, file: &str) -> String {
        format!("{}/{repository}/resolve/{revision}/{file}", self.0)
    }

    /// The host's name, for people.
    pub fn host(&self) -> String {
        host(&self.0)
    }
}

/// Whether nobody on the way can read or change what comes from there.
pub fn is_safe(uri: &Uri) -> bool {
    let host = uri.host().unwrap_or_default().trim_start_matches('[').trim_end_matches(']');
    let local =
        host == "localhost" || host.parse::<std::net::IpAddr>().is_ok_and(|address| address.is_loopback());
    uri.scheme_str() == Some("https") || local
}

/// The host's name in an address, for people.
pub fn host(address: &str) -> String {
    let uri = address.parse::<Uri>().ok();
    uri.as_ref().and_then(Uri::host).unwrap_or(address).to_owned()
}

/// Whether both addresses are of one server.
pub fn is_same_server(one: &str, other: &str) -> bool {
    let server = |address: &str| address.parse::<Uri>().ok().and_then(|uri| uri.authority().cloned());
    server(one).is_some() && server(one) == server(other)
}

/// Where a redirect from `from` leads to.
pub fn redirected(from: &str, location: &str) -> Option<String> {
    let uri: Uri = from.parse().ok()?;
    let (scheme, authority) = (uri.scheme_str()?, uri.authority()?);
    let target = if location.contains("://") {
        location.to_owned()
    } else if let Some(rest) = location.strip_prefix("//") {
        format!("{scheme}://{rest}")
    } else if location.starts_with('/') {
        format!("{scheme}://{authority}{location}")
    } else {
        let folder = uri.path().rsplit_once('/').map_or("", |(folder, _)| folder);
        format!("{scheme}://{authority}{folder}/{location}")
    };
    target.parse::<Uri>().ok().map(|_| target)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_this_machine_may_go_without_encryption() {
        for good in
            ["https://hub.example", "http://127.0.0.1:8000/", "http://localhost:1/hub", "http://[::1]:9"]
        {
            assert_eq!(Endpoint::new(Some(good)).unwrap().0, good.trim_end_matches('/'), "{good}");
        }
        for bad in [
            "http://hub.example",
            "http://10.0.0.1",
            "ftp://hub.example",
            "hub.example",
            "https://",
            "a b",
            "https://u:p@hub.example",
            "https://hub.example?x=1",
            "http://127.0.0.1.example",
        ] {
            let error = Endpoint::new(Some(bad)).unwrap_err();
            assert!(matches!(error, HubError::BadEndpoint { .. }), "{bad}: {error}");
        }
    }

    #[test]
    fn redirects_lead_where_they_say() {
        let from = "https://hub.example/a/resolve/main/x.json";
        for (location, target) in [
            ("https://cdn.example/y", "https://cdn.example/y"),
            ("//cdn.example/y", "https://cdn.example/y"),
            ("/cache/y?z=1", "https://hub.example/cache/y?z=1"),
            ("y", "https://hub.example/a/resolve/main/y"),
        ] {
            assert_eq!(redirected(from, location).as_deref(), Some(target));
        }
        assert!(
            is_same_server(from, "https://hub.example/b") && !is_same_server(from, "https://cdn.example/b")
        );
    }
}
