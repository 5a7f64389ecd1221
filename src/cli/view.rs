//! `orb view FILE|FOLDER`: one scene on a page of a local port.

use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::device::Device;
use crate::audit::DataFolder;
use crate::view::open;
use crate::view::server::{self, Site};
use crate::view::subject::Subject;
use crate::view::webgl::{Script, Webgl};
use crate::view::worker::Worker;
use crate::web::listen;
use crate::{Error, Result};

/// Threads that wait for the disk: the page has no more to read at a time.
const WAITING: usize = 1;

/// Look at a scene in a browser, from all sides, and measure in it. Ends with Ctrl-C.
#[derive(Clone, Debug, clap::Args)]
pub struct View {
    /// A published folder, or splats or a model: PLY, SPZ, GLB.
    pub scene: PathBuf,
    /// Where the page is served; port 0 takes a free one. Whoever reaches the address and knows it sees the scene.
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:0")]
    pub bind: SocketAddr,
    /// Let the page draw the scene in the browser too, by the script in this folder: viewer/dist, where `npm ci && npm run
    /// build` in viewer/ builds it.
    #[arg(long, value_name = "FOLDER")]
    pub webgl: Option<PathBuf>,
    /// Print the address only.
    #[arg(long)]
    pub no_open: bool,
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    /// No word but the address.
    #[arg(short, long)]
    pub quiet: bool,
}

/// Serves until `stop` is set by the interrupt handler.
pub fn run(args: &View, stop: &AtomicBool) -> Result<u8> {
    let script = args.webgl.as_deref().map(Script::load).transpose()?.map(Arc::new);
    let subject = Arc::new(Subject::load(&args.scene)?);
    let (device, quiet) = (args.device, args.quiet);
    let say = move |line: &str| {
        if !quiet {
            eprintln!("orb: {line}");
        }
    };
    subject.notes.iter().for_each(|note| say(note));
    let (worker, thread) = Worker::start(Arc::clone(&subject), move || device.open_quietly(&mut |line| say(line)))?;
    let advice = "Leave --bind out to take a free port of this machine.";
    let (runtime, listener, bound) = listen::open(args.bind, WAITING, advice)?;
    if !bound.ip().is_loopback() {
        eprintln!(
            "orb: warning: {} can be reached from other machines, and the scene travels there unencrypted",
            bound.ip()
        );
    }
    let token = server::token()?;
    let address = format!("http://{bound}/{token}/");
    println!("{}\n{address}", subject.banner());
    let opened = if args.no_open || !has_a_screen() {
        None
    } else {
        let opened =
            DataFolder::from_environment(|name| std::env::var_os(name)).and_then(|d| open::in_browser(&address, &d));
        opened.map_err(|e| say(&format!("no browser was opened: {e}"))).ok()
    };
    say("Ctrl-C ends it");
    let webgl = Webgl::new(script.as_ref(), &subject);
    let router = server::router(Arc::new(Site { subject, worker, webgl }), token);
    runtime.block_on(listen::serve(listener, listen::Plain, router, stop, listen::CONNECTIONS));
    drop(opened);
    // Ends the connections, and with the last of them the thread that draws.
    drop(runtime);
    thread.join().map_err(|_| Error::environment("the thread that draws").found("a panic"))?;
    Ok(0)
}

/// Whether a browser that this user sees can be opened at all.
fn has_a_screen() -> bool {
    let set = |name| std::env::var_os(name).is_some_and(|v| !v.is_empty());
    cfg!(any(windows, target_os = "macos")) || set("DISPLAY") || set("WAYLAND_DISPLAY")
}
