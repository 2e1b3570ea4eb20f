// SPDX-License-Identifier: MIT OR Apache-2.0
//! The hashes by which the hub knows its files: SHA-256 of large ones, git's of small ones.

use sha1::Sha1;
use sha2::{Digest, Sha256};

/// A file's hash, in hexadecimal.
#[derive(Debug, Clone, PartialEq)]
pub enum Hash {
    /// SHA-256 of the bytes.
    Sha256(String),
    /// SHA-1 as git makes it, over a header with the length and the bytes.
    GitBlob(String),
}

impl Hash {
    /// The hash that an entity tag is, if it is one.
    pub fn from_etag(etag: &str) -> Option<Self> {
        let bare = etag.trim().trim_start_matches("W/").trim_matches('"').to_ascii_lowercase();
        if !bare.bytes().all(|byte| byte.is_ascii_hexdigit()) {
            return None;
        }
        match bare.len() {
            64 => Some(Self::Sha256(bare)),
            40 => Some(Self::GitBlob(bare)),
            _ => None,
        }
    }

    /// Its digits.
    pub fn digits(&self) -> &str {
        let (Self::Sha256(digits) | Self::GitBlob(digits)) = self;
        digits
    }

    /// What computes such a hash of a file of `bytes` bytes.
    pub fn hasher(&self, bytes: u64) -> Hasher {
        match self {
            Self::Sha256(_) => Hasher::Sha256(Sha256::new()),
            Self::GitBlob(_) => Hasher::GitBlob(Sha1::new_with_prefix(format!("blob {bytes}\0"))),
        }
    }
}

/// A hash in the making.
pub enum Hasher {
    Sha256(Sha256),
    GitBlob(Sha1),
}

impl Hasher {
    pub fn update(&mut self, bytes: &[u8]) {
        match self {
            Self::Sha256(hasher) => hasher.update(bytes),
            Self::GitBlob(hasher) => hasher.update(bytes),
        }
    }

    pub fn finish(self) -> Hash {
        match self {
            Self::Sha256(hasher) => Hash::Sha256(digits(&hasher.finalize())),
            Self::GitBlob(hasher) => Hash::GitBlob(digits(&hasher.finalize())),
        }
    }
}

fn digits(bytes: &[u8]) -> String {
    use std::fmt::Write;
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hash_of(like: &Hash, bytes: &[u8]) -> Hash {
        let mut hasher = like.hasher(bytes.len() as u64);
        bytes.chunks(3).for_each(|chunk| hasher.update(chunk));
        hasher.finish()
    }

    #[test]
    fn the_hashes_are_those_of_git_and_sha256sum() {
        // `printf 'hello\n' | git hash-object --stdin` and `| sha256sum`.
        let git = Hash::from_etag("\"ce013625030ba8dba906f756967f9e9ca394464a\"").unwrap();
        assert_eq!(hash_of(&git, b"hello\n"), git);
        let sum = "5891b5b522d5df086d0ff0b110fbd9d21bb4fc7163af34d08286a2e846f6be03";
        let sha256 = Hash::from_etag(&format!("W/\"{}\"", sum.to_uppercase())).unwrap();
        assert_eq!(hash_of(&sha256, b"hello\n"), sha256);
    }

    #[test]
    fn other_tags_are_no_hashes() {
        for tag in [
            "",
            "\"abc\"",
            "\"ce013625030ba8dba906f756967f9e9ca394464a-gzip\"",
            "d41d8cd98f00b204e9800998ecf8427e",
        ] {
            assert_eq!(Hash::from_etag(tag), None, "{tag}");
        }
    }
}
