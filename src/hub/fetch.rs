// SPDX-License-Identifier: MIT OR Apache-2.0
//! One file, from the server to the disk: what is here already is kept, what comes is checked.

use std::fs::{File, OpenOptions};
use std::io::{Read, Write};
use std::path::Path;
use std::time::{Duration, Instant};

use super::client::{Client, Event};
use super::hash::{Hash, Hasher};
use super::progress::Harness;
use super::staging::{Staging, remove_file};
use super::wanted::Wanted;
use super::{HubError, endpoint};

/// Tries in a row that bring nothing new, before it is given up.
const TRIES: u32 = 4;

/// A file as the server announces it.
#[derive(Debug, Clone)]
pub struct Announced {
    pub wanted: Wanted,
    pub hash: Hash,
    pub bytes: u64,
}

/// What fetching needs besides the file.
pub struct Fetch<'a> {
    pub client: &'a Client,
    pub staging: &'a Staging,
    pub harness: &'a Harness,
    /// The wait before the second try; it doubles with each.
    pub pause: Duration,
}

impl Fetch<'_> {
    /// Calls `work` until it succeeds, fails for good, or fails too often in a row. `work` says how far it came.
    pub fn persist<T>(&self, mut work: impl FnMut(&mut u64) -> Result<T, HubError>) -> Result<T, HubError> {
        let (mut reached, mut furthest, mut tries) = (0, 0, 0);
        loop {
            let error = match work(&mut reached) {
                Err(error) if error.is_transient() => error,
                done => return done,
            };
            tries = if reached > furthest { 1 } else { tries + 1 };
            furthest = furthest.max(reached);
            if tries >= TRIES {
                return Err(error);
            }
            let pause = self.pause * 2_u32.pow(tries - 1);
            let pause = if let HubError::TooMany { wait, .. } = &error { pause.max(*wait) } else { pause };
            self.harness.update(|progress| progress.trouble = error.to_string());
            self.sleep(pause)?;
        }
    }

    /// Brings a file into the staging folder, whole and checked.
    pub fn file(&self, announced: &Announced) -> Result<(), HubError> {
        let name = announced.wanted.file.clone();
        self.harness.update(|progress| progress.file.clone_from(&name));
        let whole = self.staging.whole(&name);
        let part = self.staging.part(&name, &announced.hash)?;
        if whole.is_file() {
            // A crash may have cut it short.
            std::fs::rename(&whole, &part).map_err(|error| HubError::folder(&whole, &error))?;
        }
        let went_on = part.metadata().is_ok_and(|meta| meta.len() > 0);
        let mut result = self.persist(|reached| self.run(announced, &part, reached));
        let damaged = |result: &Result<(), HubError>| matches!(result, Err(HubError::WrongHash { .. }));
        if went_on && damaged(&result) {
            // What an earlier run left may be at fault.
            self.forget(&part)?;
            result = self.persist(|reached| self.run(announced, &part, reached));
        }
        if damaged(&result) {
            self.forget(&part)?;
        }
        result?;
        std::fs::rename(&part, &whole).map_err(|error| HubError::folder(&whole, &error))
    }

    /// One try: hashes what is here, adds what is missing, and compares. `reached` is how far the file goes.
    fn run(&self, announced: &Announced, part: &Path, reached: &mut u64) -> Result<(), HubError> {
        let failed = |error: std::io::Error| HubError::folder(part, &error);
        let mut hasher = announced.hash.hasher(announced.bytes);
        let mut file = OpenOptions::new().create(true).read(true).append(true).open(part).map_err(failed)?;
        let mut here = file.metadata().map_err(failed)?.len();
        if here > announced.bytes {
            file.set_len(0).map_err(failed)?;
            here = 0;
        }
        self.read_through(&mut file, &mut hasher).map_err(failed)?;
        self.is_going_on()?;
        if here < announced.bytes {
            self.harness.update(|progress| progress.phase = "Downloading".into());
            let stream = self.client.bytes(&announced.wanted, here)?;
            let cancelled = || self.harness.is_cancelled();
            while let Some(event) = stream.next(&cancelled)? {
                match event {
                    Event::Begins(begins) if begins < here => {
                        // The server knows no places to go on from.
                        self.harness.update(|progress| progress.bytes = progress.bytes.saturating_sub(here));
                        file.set_len(0).map_err(failed)?;
                        hasher = announced.hash.hasher(announced.bytes);
                        here = 0;
                    }
                    Event::Begins(_) => {}
                    Event::Bytes(bytes) => {
                        // More than announced is not written, and is found by the hash.
                        let room = usize::try_from(announced.bytes - here).unwrap_or(usize::MAX);
                        let is_more = bytes.len() > room;
                        let bytes = &bytes[..bytes.len().min(room)];
                        file.write_all(bytes).map_err(failed)?;
                        hasher.update(bytes);
                        here += bytes.len() as u64;
                        *reached = here;
                        self.harness.count(bytes.len() as u64);
                        if is_more {
                            return Err(wrong(announced));
                        }
                    }
                }
            }
        }
        if here < announced.bytes {
            let reason = "it ended too early".into();
            return Err(HubError::Cut { host: endpoint::host(&announced.wanted.address), reason });
        }
        file.sync_all().map_err(failed)?;
        if hasher.finish() == announced.hash { Ok(()) } else { Err(wrong(announced)) }
    }

    fn read_through(&self, file: &mut File, hasher: &mut Hasher) -> std::io::Result<()> {
        let mut piece = vec![0; 1 << 20];
        while !self.harness.is_cancelled() {
            match file.read(&mut piece)? {
                0 => return Ok(()),
                count => {
                    self.harness.update(|progress| progress.phase = "Checking what is here".into());
                    hasher.update(&piece[..count]);
                }
            }
        }
        Ok(())
    }

    /// Deletes a part, and counts its bytes no more.
    fn forget(&self, part: &Path) -> Result<(), HubError> {
        let bytes = part.metadata().map_or(0, |meta| meta.len());
        self.harness.update(|progress| progress.bytes = progress.bytes.saturating_sub(bytes));
        remove_file(part)
    }

    fn sleep(&self, pause: Duration) -> Result<(), HubError> {
        let until = Instant::now() + pause;
        while Instant::now() < until {
            self.is_going_on()?;
            std::thread::sleep(Duration::from_millis(50).min(pause));
        }
        Ok(())
    }

    fn is_going_on(&self) -> Result<(), HubError> {
        if self.harness.is_cancelled() { Err(HubError::Cancelled) } else { Ok(()) }
    }
}

fn wrong(announced: &Announced) -> HubError {
    let host = endpoint::host(&announced.wanted.address);
    HubError::WrongHash { file: announced.wanted.file.clone(), host }
}
