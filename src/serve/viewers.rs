//! Scenes of jobs that somebody looks at, drawn as `orb view` draws them. The few last ones are kept.

use std::path::Path;
use std::sync::{Arc, Mutex};

use super::lock;
use crate::Result;
use crate::cli::device::Device;
use crate::view::server::Site;
use crate::view::subject::Subject;
use crate::view::webgl::{Script, Webgl};
use crate::view::worker::Worker;

/// Scenes at once: each has a thread and its Gaussians in memory.
const MOST: usize = 2;

pub struct Viewers {
    device: Device,
    /// What browsers draw with themselves, where they may.
    script: Option<Arc<Script>>,
    /// The last used at the end.
    open: Mutex<Vec<(String, Arc<Site>)>>,
    /// Scenes are read one at a time.
    reading: Mutex<()>,
}

impl Viewers {
    pub fn new(device: Device, script: Option<Arc<Script>>) -> Viewers {
        Viewers { device, script, open: Mutex::default(), reading: Mutex::default() }
    }

    fn kept(&self, id: &str) -> Option<Arc<Site>> {
        let mut open = lock(&self.open);
        let at = open.iter().position(|(own, _)| own == id)?;
        let found = open.remove(at);
        let site = Arc::clone(&found.1);
        open.push(found);
        Some(site)
    }

    /// Reads a scene where it is not kept; that takes a moment.
    ///
    /// # Errors
    /// As [`Subject::load`] and [`Worker::start`].
    pub fn open(&self, id: &str, name: &str, folder: &Path) -> Result<Arc<Site>> {
        if let Some(site) = self.kept(id) {
            return Ok(site);
        }
        let _one = lock(&self.reading);
        if let Some(site) = self.kept(id) {
            return Ok(site);
        }
        let mut subject = Subject::load(folder)?;
        name.clone_into(&mut subject.name);
        let subject = Arc::new(subject);
        let device = self.device;
        // The thread ends with the last who holds its worker.
        let (worker, _) = Worker::start(Arc::clone(&subject), move || device.open_quietly(&mut |_| {}))?;
        let webgl = Webgl::new(self.script.as_ref(), &subject);
        let site = Arc::new(Site { subject, worker, webgl });
        let mut open = lock(&self.open);
        if open.len() >= MOST {
            open.remove(0);
        }
        open.push((id.to_owned(), Arc::clone(&site)));
        Ok(site)
    }

    pub fn close(&self, id: &str) {
        lock(&self.open).retain(|(own, _)| own != id);
    }
}
