//! The one thread that draws. What nobody waits for any more is not drawn.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use tokio::sync::oneshot;

use super::draw::{Draw, Point, Splats};
use super::query::Query;
use super::subject::Subject;
use crate::splat::Camera;
use crate::splat::render::gpu::Gpu;
use crate::{Error, Result};

/// Jobs that may wait: a page has one in hand, and one more when it changes its mind.
const WAITING: usize = 8;

#[derive(Clone, Copy, Debug)]
enum Ask {
    Picture,
    Point,
}

struct Job {
    ask: Ask,
    query: Query,
    camera: Camera,
    reply: oneshot::Sender<Result<Answer>>,
}

enum Answer {
    Picture(Vec<u8>, Duration),
    Point(Option<Point>),
}

/// Why there is no answer.
#[derive(Debug)]
pub enum Refusal {
    /// Too many are waiting.
    Busy,
    /// The thread has ended.
    Gone,
    Failed(Error),
}

/// Sends jobs to the thread; it ends with the last of its senders.
#[derive(Clone)]
pub struct Worker {
    jobs: SyncSender<Job>,
}

impl Worker {
    /// Starts the thread and waits until it is ready to draw. `open` runs on it and gives the GPU, if one is to be used.
    ///
    /// # Errors
    /// What `open` returns; environment, from the GPU.
    pub fn start(
        subject: Arc<Subject>,
        open: impl FnOnce() -> Result<Option<Gpu>> + Send + 'static,
    ) -> Result<(Worker, JoinHandle<()>)> {
        let (jobs, queue) = sync_channel(WAITING);
        let (ready, started) = sync_channel(1);
        let run = move || {
            let gpu = match open() {
                Ok(gpu) => gpu,
                Err(e) => return drop(ready.send(Err(e))),
            };
            match subject.gaussians.as_ref().map(|g| Splats::new(g, gpu.as_ref())).transpose() {
                Ok(splats) => {
                    let _ = ready.send(Ok(()));
                    work(Draw::new(&subject, splats), &queue);
                }
                Err(e) => drop(ready.send(Err(e))),
            }
        };
        let failed = |found: String| Error::environment("the thread that draws").found(found);
        let thread = std::thread::Builder::new().name("draw".into()).spawn(run).map_err(|e| failed(e.to_string()))?;
        started.recv().map_err(|_| failed("it ended".into()))??;
        Ok((Worker { jobs }, thread))
    }

    /// A JPEG, and how long it took to draw.
    pub async fn picture(&self, query: Query, camera: Camera) -> Result<(Vec<u8>, Duration), Refusal> {
        match self.ask(Ask::Picture, query, camera).await? {
            Answer::Picture(jpeg, took) => Ok((jpeg, took)),
            Answer::Point(_) => Err(Refusal::Gone),
        }
    }

    pub async fn point(&self, query: Query, camera: Camera) -> Result<Option<Point>, Refusal> {
        match self.ask(Ask::Point, query, camera).await? {
            Answer::Point(point) => Ok(point),
            Answer::Picture(..) => Err(Refusal::Gone),
        }
    }

    async fn ask(&self, ask: Ask, query: Query, camera: Camera) -> Result<Answer, Refusal> {
        let (reply, answer) = oneshot::channel();
        self.jobs.try_send(Job { ask, query, camera, reply }).map_err(|e| match e {
            TrySendError::Full(_) => Refusal::Busy,
            TrySendError::Disconnected(_) => Refusal::Gone,
        })?;
        answer.await.map_err(|_| Refusal::Gone)?.map_err(Refusal::Failed)
    }
}

fn work(mut draw: Draw, queue: &Receiver<Job>) {
    for job in queue {
        // Who asked has gone, or has asked for something else since.
        if job.reply.is_closed() {
            continue;
        }
        let begin = Instant::now();
        let answer = match job.ask {
            Ask::Picture => draw.picture(&job.query, &job.camera).map(|jpeg| Answer::Picture(jpeg, begin.elapsed())),
            Ask::Point => draw.point(&job.query, &job.camera).map(Answer::Point),
        };
        let _ = job.reply.send(answer);
    }
}
