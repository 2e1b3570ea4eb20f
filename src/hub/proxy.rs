// SPDX-License-Identifier: MIT OR Apache-2.0
//! The proxy that the environment names for a host, read as other programs read it.

/// The address of the proxy for a URL of this scheme and host; none where it is reached directly.
///
/// `variable` reads the environment. Lower case comes first, and `HTTP_PROXY` is not read in upper case, as
/// curl does.
pub fn proxy_for(scheme: &str, host: &str, variable: impl Fn(&str) -> Option<String>) -> Option<String> {
    let named = |name: &str| variable(name).map(|value| value.trim().to_owned()).filter(|v| !v.is_empty());
    let either = |name: &str| named(&name.to_ascii_lowercase()).or_else(|| named(name));
    let own = if scheme == "https" { either("HTTPS_PROXY") } else { named("http_proxy") };
    let proxy = own.or_else(|| either("ALL_PROXY"))?;
    let spared =
        either("NO_PROXY").is_some_and(|list| list.split(',').any(|entry| spares(entry.trim(), host)));
    (!spared).then_some(proxy)
}

/// Whether an entry of `NO_PROXY` names this host or a domain that it is in.
fn spares(entry: &str, host: &str) -> bool {
    let entry =
        entry.split_once(':').filter(|(_, port)| port.parse::<u16>().is_ok()).map_or(entry, |(name, _)| name);
    let domain = entry.trim_start_matches('*').trim_start_matches('.').to_ascii_lowercase();
    let host = host.to_ascii_lowercase();
    match host.strip_suffix(&domain) {
        _ if entry == "*" => true,
        _ if domain.is_empty() => false,
        Some(before) => before.is_empty() || before.ends_with('.'),
        None => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(scheme: &str, host: &str, environment: &[(&str, &str)]) -> Option<String> {
        let find =
            |name: &str| environment.iter().find(|(known, _)| *known == name).map(|(_, v)| (*v).to_owned());
        proxy_for(scheme, host, find)
    }

    #[test]
    fn each_scheme_has_its_variable() {
        let both =
            [("HTTPS_PROXY", "http://a:1"), ("http_proxy", "http://b:2"), ("HTTP_PROXY", "http://c:3")];
        assert_eq!(asked("https", "hub.example", &both).as_deref(), Some("http://a:1"));
        assert_eq!(asked("http", "hub.example", &both).as_deref(), Some("http://b:2"));
        assert_eq!(asked("http", "hub.example", &both[2..]), None);
        assert_eq!(
            asked("http", "hub.example", &[("ALL_PROXY", "http://d:4")]).as_deref(),
            Some("http://d:4")
        );
        assert_eq!(asked("https", "hub.example", &[("HTTPS_PROXY", " ")]), None);
    }

    #[test]
    fn hosts_are_spared_with_their_domains() {
        for (list, host, spared) in [
            ("hub.example", "hub.example", true),
            ("hub.example", "cdn.hub.example", true),
            ("hub.example", "myhub.example", false),
            ("other, .hub.example", "cdn.hub.example", true),
            ("*.hub.example", "CDN.hub.example", true),
            ("hub.example:443", "hub.example", true),
            ("*", "hub.example", true),
            ("", "hub.example", false),
            ("127.0.0.1", "127.0.0.1", true),
        ] {
            let proxy = asked("https", host, &[("HTTPS_PROXY", "http://a:1"), ("NO_PROXY", list)]);
            assert_eq!(proxy.is_none(), spared, "{list} and {host}");
        }
    }
}
