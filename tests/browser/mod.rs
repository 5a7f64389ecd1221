//! A headless Chromium, driven over its DevTools protocol through a pair of pipes: JSON messages that end with a zero byte.
#![allow(dead_code, reason = "each test that drives a browser uses a part of it")]

use std::io::{BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use base64::Engine as _;
use serde_json::{Value, json};

/// Longest wait for anything.
const PATIENCE: Duration = Duration::from_secs(60);

pub struct Browser {
    child: Child,
    input: ChildStdin,
    output: Receiver<Value>,
    session: String,
    last: u64,
    complaints: Vec<String>,
}

/// What Debian and others call it.
fn program() -> Option<PathBuf> {
    let names = ["chromium", "chromium-browser", "google-chrome"];
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    names.iter().flat_map(|n| folders.iter().map(move |f| f.join(n))).find(|p| p.is_file())
}

impl Browser {
    /// `None`, with the reason printed, where there is no Chromium. Its profile goes into `folder`. It has no WebGL.
    pub fn start(folder: &Path) -> Option<Browser> {
        Browser::start_with(folder, &["--disable-gpu", "--disable-webgl", "--disable-3d-apis"])
    }

    /// With WebGL, drawn by the processor.
    pub fn with_webgl(folder: &Path) -> Option<Browser> {
        Browser::start_with(
            folder,
            &["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
        )
    }

    pub fn start_with(folder: &Path, options: &[&str]) -> Option<Browser> {
        let Some(program) = program() else {
            assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none_or(|v| v != "1"), "chromium is not on the PATH");
            eprintln!("skipped: chromium is not on the PATH");
            return None;
        };
        // The protocol's pipes are the descriptors 3 and 4. --no-sandbox: tests may run as root, and open their own page only.
        let mut child = Command::new("sh")
            .args(["-c", "exec \"$0\" \"$@\" 3<&0 4>&1 </dev/null >/dev/null 2>&1"])
            .arg(program)
            .args(["--headless=new", "--remote-debugging-pipe", "--no-sandbox", "--disable-dev-shm-usage"])
            .args(["--no-first-run", "--disable-background-networking"])
            .args(options)
            .arg(format!("--user-data-dir={}", folder.join("browser").display()))
            .arg("about:blank")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (input, pipe) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
        let (send, output) = channel();
        std::thread::spawn(move || {
            for message in BufReader::new(pipe).split(0) {
                let Ok(message) = message else { break };
                if send.send(serde_json::from_slice(&message).unwrap()).is_err() {
                    break;
                }
            }
        });
        let mut browser = Browser { child, input, output, session: String::new(), last: 0, complaints: Vec::new() };
        let target = browser.call("Target.createTarget", json!({"url": "about:blank"}))["targetId"].clone();
        let session = browser.call("Target.attachToTarget", json!({"targetId": target, "flatten": true}));
        browser.session = session["sessionId"].as_str().unwrap().to_owned();
        for domain in ["Page.enable", "Runtime.enable", "Log.enable"] {
            browser.call(domain, json!({}));
        }
        Some(browser)
    }

    fn call(&mut self, method: &str, params: Value) -> Value {
        self.asked(method, params).unwrap_or_else(|error| panic!("{method}: {error}"))
    }

    /// The answer, or the error that the browser answers with.
    fn asked(&mut self, method: &str, params: Value) -> Result<Value, Value> {
        self.last += 1;
        let mut message = json!({"id": self.last, "method": method, "params": params});
        if !self.session.is_empty() {
            message["sessionId"] = self.session.clone().into();
        }
        let mut bytes = serde_json::to_vec(&message).unwrap();
        bytes.push(0);
        self.input.write_all(&bytes).unwrap();
        self.input.flush().unwrap();
        loop {
            let answer = self.output.recv_timeout(PATIENCE).unwrap_or_else(|e| panic!("{method}: {e}"));
            match answer["method"].as_str() {
                Some("Runtime.exceptionThrown" | "Log.entryAdded") => {
                    self.complaints.push(answer["params"].to_string())
                }
                Some(_) => {}
                None if answer["id"] == self.last => {
                    let error = &answer["error"];
                    return if error.is_null() { Ok(answer["result"].clone()) } else { Err(error.clone()) };
                }
                None => {}
            }
        }
    }

    /// Pixels across and down as the page counts them, how many of the screen's make one, and whether it is touched.
    pub fn size(&mut self, width: u32, height: u32, factor: f64, touch: bool) {
        let metrics = json!({"width": width, "height": height, "deviceScaleFactor": factor, "mobile": touch});
        self.call("Emulation.setDeviceMetricsOverride", metrics);
        self.call("Emulation.setTouchEmulationEnabled", json!({"enabled": touch}));
    }

    pub fn open(&mut self, address: &str) {
        self.call("Page.navigate", json!({"url": address}));
    }

    /// Loads the page anew; returns before it is.
    pub fn reload(&mut self) {
        self.call("Page.reload", json!({}));
    }

    /// An expression's value as text, awaited if it is a promise.
    pub fn value(&mut self, expression: &str) -> String {
        let asked = json!({"expression": expression, "awaitPromise": true, "returnByValue": true});
        let answer = self.call("Runtime.evaluate", asked);
        assert!(answer["exceptionDetails"].is_null(), "{expression}: {}", answer["exceptionDetails"]);
        answer["result"]["value"].as_str().unwrap_or_default().to_owned()
    }

    /// Waits until the expression holds.
    pub fn until(&mut self, expression: &str) {
        self.until_within(expression, PATIENCE);
    }

    pub fn until_within(&mut self, expression: &str, patience: Duration) {
        let end = Instant::now() + patience;
        // The page may not be there yet, or give way to another while it is asked: what cannot be evaluated does not hold.
        let asked = format!("(() => {{ try {{ return !!({expression}) }} catch {{ return false }} }})()");
        let asked = json!({"expression": asked, "returnByValue": true});
        while !self.asked("Runtime.evaluate", asked.clone()).is_ok_and(|a| a["result"]["value"] == true) {
            if Instant::now() > end {
                let state = self.value("document.body.innerText");
                panic!("{expression} does not hold after {patience:?}: {state}\n{:?}", self.complaints);
            }
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    pub fn key(&mut self, key: &str) {
        // A form is sent by the character that Enter types.
        let (text, code) = if key == "Enter" { ("\r", 13) } else { ("", 0) };
        for kind in ["keyDown", "keyUp"] {
            let text = if kind == "keyDown" { text } else { "" };
            let event = json!({"type": kind, "key": key, "text": text, "windowsVirtualKeyCode": code});
            self.call("Input.dispatchKeyEvent", event);
        }
    }

    /// Types into what has the focus.
    pub fn text(&mut self, text: &str) {
        self.call("Input.insertText", json!({"text": text}));
    }

    /// Gives a file to a field for one.
    pub fn choose(&mut self, selector: &str, file: &Path) {
        self.choose_all(selector, &[file]);
    }

    /// Gives files to a field for several.
    pub fn choose_all(&mut self, selector: &str, files: &[&Path]) {
        let root = self.call("DOM.getDocument", json!({}))["root"]["nodeId"].clone();
        let found = self.call("DOM.querySelector", json!({"nodeId": root, "selector": selector}));
        self.call("DOM.setFileInputFiles", json!({"nodeId": found["nodeId"], "files": files}));
    }

    pub fn click(&mut self, x: f64, y: f64) {
        for kind in ["mousePressed", "mouseReleased"] {
            let event = json!({"type": kind, "x": x, "y": y, "button": "left", "clickCount": 1});
            self.call("Input.dispatchMouseEvent", event);
        }
    }

    /// A picture of the page, kept where ORB_VIEW_PICTURES names a folder. It is never empty.
    pub fn picture(&mut self, name: &str) {
        let shot = self.call("Page.captureScreenshot", json!({"format": "png"}));
        let bytes = base64::engine::general_purpose::STANDARD.decode(shot["data"].as_str().unwrap()).unwrap();
        let colours: std::collections::BTreeSet<[u8; 4]> =
            image::load_from_memory(&bytes).unwrap().into_rgba8().pixels().map(|p| p.0).collect();
        assert!(colours.len() > 100, "{name}: {} colours", colours.len());
        if let Some(folder) = std::env::var_os("ORB_VIEW_PICTURES") {
            std::fs::write(Path::new(&folder).join(format!("{name}.png")), bytes).unwrap();
        }
    }

    /// Along these points, with the left button held.
    pub fn drag(&mut self, points: &[[f64; 2]]) {
        let last = points.len() - 1;
        for (i, [x, y]) in points.iter().enumerate() {
            for kind in ["mouseMoved", "mousePressed", "mouseReleased"] {
                if kind == "mouseMoved" || (kind == "mousePressed" && i == 0) || (kind == "mouseReleased" && i == last)
                {
                    let buttons = i32::from(i > 0 || kind != "mouseMoved");
                    let button = if buttons == 1 { "left" } else { "none" };
                    let event =
                        json!({"type": kind, "x": x, "y": y, "button": button, "buttons": buttons, "clickCount": 1});
                    self.call("Input.dispatchMouseEvent", event);
                }
            }
        }
    }

    pub fn wheel(&mut self, x: f64, y: f64, down: f64) {
        let event = json!({"type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": down});
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Fingers, step by step; at the end they are lifted.
    pub fn touch(&mut self, steps: &[&[[f64; 2]]]) {
        for (i, fingers) in steps.iter().enumerate() {
            let points: Vec<Value> =
                fingers.iter().enumerate().map(|(id, [x, y])| json!({"x": x, "y": y, "id": id})).collect();
            let kind = if i == 0 { "touchStart" } else { "touchMove" };
            self.call("Input.dispatchTouchEvent", json!({"type": kind, "touchPoints": points}));
        }
        self.call("Input.dispatchTouchEvent", json!({"type": "touchEnd", "touchPoints": []}));
    }

    /// What stands on the screen where an element is.
    pub fn pixels(&mut self, selector: &str) -> image::RgbImage {
        let place = self.value(&format!(
            "(r => [r.x, r.y, r.width, r.height].join(' '))(document.querySelector('{selector}').getBoundingClientRect())"
        ));
        let place: Vec<f64> = place.split(' ').map(|v| v.parse().unwrap()).collect();
        let clip = json!({"x": place[0], "y": place[1], "width": place[2], "height": place[3], "scale": 1});
        let shot = self.call("Page.captureScreenshot", json!({"format": "png", "clip": clip}));
        let bytes = base64::engine::general_purpose::STANDARD.decode(shot["data"].as_str().unwrap()).unwrap();
        image::load_from_memory(&bytes).unwrap().into_rgb8()
    }

    /// MiB of memory that its processes have now.
    #[cfg(target_os = "linux")]
    pub fn memory(&self) -> f64 {
        let number = |entry: &std::fs::DirEntry| entry.file_name().to_str()?.parse::<u32>().ok();
        let processes: Vec<(u32, u32, f64)> = std::fs::read_dir("/proc")
            .unwrap()
            .filter_map(|e| {
                let id = number(&e.ok()?)?;
                let stat = std::fs::read_to_string(format!("/proc/{id}/stat")).ok()?;
                let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
                // Of what several processes share, each has its part (Pss), in KiB.
                let rollup = std::fs::read_to_string(format!("/proc/{id}/smaps_rollup")).ok()?;
                let pss =
                    rollup.lines().find_map(|l| l.strip_prefix("Pss:"))?.split_whitespace().next()?.parse::<f64>();
                Some((id, fields[1].parse().ok()?, pss.ok()? / 1024.0))
            })
            .collect();
        let mut own = vec![self.child.id()];
        let mut at = 0;
        while at < own.len() {
            let of = own[at];
            own.extend(processes.iter().filter(|(_, parent, _)| *parent == of).map(|(id, ..)| *id));
            at += 1;
        }
        processes.iter().filter(|(id, ..)| own.contains(id)).map(|(.., mib)| mib).sum()
    }

    /// Exceptions and what the browser wrote into its log.
    pub fn complaints(&self) -> Vec<String> {
        self.complaints.clone()
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
