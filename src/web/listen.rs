//! Connections: few, small, and none that may dawdle.

use std::future::{Pending, pending, poll_fn};
use std::io;
use std::net::SocketAddr;
use std::pin::{Pin, pin};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::task::{Context, Poll, ready};
use std::time::Duration;

use axum::Router;
use hyper::Request;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service as _, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::net::{TcpListener, TcpStream};
use tokio::runtime::Runtime;
use tokio::sync::Semaphore;
use tokio::time::{Instant, Sleep, sleep, timeout};

use crate::{Error, Result};

/// Connections at once, for a page of one user's; a browser opens six.
pub const CONNECTIONS: usize = 64;
/// Until the head of the next request has come; an idle connection is closed after it too.
const HEAD: Duration = Duration::from_secs(10);
/// Until the client takes more of an answer.
const PATIENCE: Duration = Duration::from_secs(10);
/// How often the interrupt handler's word is looked at.
const LOOK: Duration = Duration::from_millis(200);
/// Bytes of a request's head, and of an answer on its way.
const BUFFER: usize = 16 << 10;

/// How a connection that came in becomes one that speaks HTTP.
pub trait Entrance: Clone + Send + Sync + 'static {
    type Stream: AsyncRead + AsyncWrite + Unpin + Send;
    /// What was learnt of the other end: an extension of each request.
    type Peer: Clone + Send + Sync + 'static;
    /// Done when the other end may be here no longer: the connection ends then, whatever is under way on it.
    type Over: Future<Output = ()> + Send + Unpin;

    /// `None` for one that is not let in. It counts as a connection meanwhile, and must end by itself.
    fn enter(&self, stream: Patient) -> impl Future<Output = Option<(Self::Stream, Self::Peer, Self::Over)>> + Send;
}

/// HTTP as it is.
#[derive(Clone, Copy, Debug)]
pub struct Plain;

impl Entrance for Plain {
    type Stream = Patient;
    type Peer = ();
    type Over = Pending<()>;

    async fn enter(&self, stream: Patient) -> Option<(Patient, (), Pending<()>)> {
        Some((stream, (), pending()))
    }
}

/// Takes a port: what runs the answers (on this thread, with `blocking` more that wait for the disk), what listens, and
/// where, if `address` asked for any free port.
///
/// Errors: `Environment`, with `advice`, when the address is not this machine's or the port is taken.
pub fn open(address: SocketAddr, blocking: usize, advice: &str) -> Result<(Runtime, TcpListener, SocketAddr)> {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .max_blocking_threads(blocking)
        .build()
        .map_err(|e| Error::environment("the server").found(e.to_string()))?;
    let cannot = |e: io::Error| {
        Error::environment(address.to_string())
            .expected("an address of this machine with a free port")
            .found(e.to_string())
            .advice(advice)
    };
    let listener = runtime.block_on(TcpListener::bind(address)).map_err(cannot)?;
    let bound = listener.local_addr().map_err(cannot)?;
    Ok((runtime, listener, bound))
}

/// Answers at most `connections` at once, until `stop` is set.
pub async fn serve(
    listener: TcpListener,
    entrance: impl Entrance,
    router: Router,
    stop: &AtomicBool,
    connections: usize,
) {
    let places = Arc::new(Semaphore::new(connections));
    while !stop.load(Ordering::Relaxed) {
        let Ok(place) = timeout(LOOK, Arc::clone(&places).acquire_owned()).await else { continue };
        let stream = match timeout(LOOK, listener.accept()).await {
            Ok(Ok((stream, _))) => stream,
            Ok(Err(_)) => {
                // Out of file handles, most likely: they come back.
                sleep(LOOK).await;
                continue;
            }
            Err(_) => continue,
        };
        let service = TowerToHyperService::new(router.clone());
        let entrance = entrance.clone();
        tokio::spawn(async move {
            let _ = stream.set_nodelay(true);
            let Some((stream, peer, mut over)) = entrance.enter(Patient::new(stream)).await else { return drop(place) };
            let service = service_fn(move |mut request: Request<Incoming>| {
                request.extensions_mut().insert(peer.clone());
                service.call(request)
            });
            let mut http = http1::Builder::new();
            http.timer(TokioTimer::new()).header_read_timeout(HEAD).max_buf_size(BUFFER).max_headers(64);
            let mut connection = pin!(http.serve_connection(TokioIo::new(stream), service));
            // Who breaks the connection off has no use for an error.
            poll_fn(|cx| match Pin::new(&mut over).poll(cx) {
                Poll::Ready(()) => Poll::Ready(()),
                Poll::Pending => connection.as_mut().poll(cx).map(|_| ()),
            })
            .await;
            drop(place);
        });
    }
}

/// A stream whose other end must take what is written, sooner or later.
pub struct Patient {
    stream: TcpStream,
    waiting: Option<Pin<Box<Sleep>>>,
}

impl Patient {
    fn new(stream: TcpStream) -> Patient {
        Patient { stream, waiting: None }
    }

    /// What has come, left where it is.
    ///
    /// # Errors
    /// As [`TcpStream::peek`].
    pub async fn peek(&self, bytes: &mut [u8]) -> io::Result<usize> {
        self.stream.peek(bytes).await
    }

    /// An error once nothing was taken for too long.
    fn watch<T>(&mut self, cx: &mut Context<'_>, poll: Poll<io::Result<T>>) -> Poll<io::Result<T>> {
        if poll.is_ready() {
            self.waiting = None;
            return poll;
        }
        let waiting = self.waiting.get_or_insert_with(|| Box::pin(tokio::time::sleep_until(Instant::now() + PATIENCE)));
        ready!(waiting.as_mut().poll(cx));
        Poll::Ready(Err(io::ErrorKind::TimedOut.into()))
    }
}

impl AsyncRead for Patient {
    fn poll_read(mut self: Pin<&mut Self>, cx: &mut Context<'_>, buffer: &mut ReadBuf<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_read(cx, buffer)
    }
}

impl AsyncWrite for Patient {
    fn poll_write(mut self: Pin<&mut Self>, cx: &mut Context<'_>, bytes: &[u8]) -> Poll<io::Result<usize>> {
        let poll = Pin::new(&mut self.stream).poll_write(cx, bytes);
        self.watch(cx, poll)
    }

    fn poll_write_vectored(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        parts: &[io::IoSlice<'_>],
    ) -> Poll<io::Result<usize>> {
        let poll = Pin::new(&mut self.stream).poll_write_vectored(cx, parts);
        self.watch(cx, poll)
    }

    fn is_write_vectored(&self) -> bool {
        self.stream.is_write_vectored()
    }

    fn poll_flush(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        let poll = Pin::new(&mut self.stream).poll_flush(cx);
        self.watch(cx, poll)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        let poll = Pin::new(&mut self.stream).poll_shutdown(cx);
        self.watch(cx, poll)
    }
}
