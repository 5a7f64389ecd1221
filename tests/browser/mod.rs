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
    /// `None`, with the reason printed, where there is no Chromium. Its profile goes into `folder`.
    pub fn start(folder: &Path) -> Option<Browser> {
        let Some(program) = program() else {
            assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none_or(|v| v != "1"), "chromium is not on the PATH");
            eprintln!("skipped: chromium is not on the PATH");
            return None;
        };
        // The protocol's pipes are the descriptors 3 and 4. --no-sandbox: tests may run as root, and open their own page only.
        let mut child = Command::new("sh")
            .args(["-c", "exec \"$0\" \"$@\" 3<&0 4>&1 </dev/null >/dev/null 2>&1"])
            .arg(program)
            .args([
                "--headless=new",
                "--remote-debugging-pipe",
                "--no-sandbox",
                "--disable-gpu",
                "--disable-dev-shm-usage",
            ])
            .args(["--no-first-run", "--disable-background-networking", "--disable-webgl", "--disable-3d-apis"])
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
                    assert!(answer["error"].is_null(), "{method}: {}", answer["error"]);
                    return answer["result"].clone();
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
        // The page may not be there yet: what cannot be evaluated does not hold.
        let asked = format!("(() => {{ try {{ return String(!!({expression})) }} catch {{ return 'false' }} }})()");
        while self.value(&asked) != "true" {
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
