"""Schemathesis against a server of its own: every operation of /openapi.json, by four accounts and by nobody.

    python check_api.py ORB PHOTO      # schemathesis stands beside this python

A job is made first, so that what it published can be asked for; then every operation is asked what the document allows and
what it does not, with a fixed seed. The server must answer as the document says, refuse what it forbids, and be as well
afterwards as before. What is not judged: whether a photo or a coordinate that fits the schema of a submission is one (no
schema says that).
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from concurrent.futures import ThreadPoolExecutor

SEED = "20261122"
EXAMPLES = "15"
ROLES = ["operator", "auditor", "admin", "monitor"]
# Too long is refused as well as wrong: by what RFC 9110 has for each.
REFUSALS = [400, 401, 403, 404, 405, 406, 408, 409, 413, 414, 415, 422, 428, 429]


def add_account(orb, role):
    made = [orb, "serve", "account", "add", role, "--role", role, "--ceiling", "UNCLASSIFIED"]
    return subprocess.run(made, check=True, capture_output=True, text=True).stdout.strip()


def ask(url, token, method="GET", body=None, content_type=None):
    headers = {"Authorization": f"Bearer {token}"}
    if content_type:
        headers["Content-Type"] = content_type
    request = urllib.request.Request(url, data=body, method=method, headers=headers)
    with urllib.request.urlopen(request, timeout=30) as answer:
        return json.load(answer)


def submit(url, token, photo):
    """A job in draft quality; its id once it is done."""
    fields = {"origin": "34.5523,-118.4712,740", "quality": "draft", "format": "glb"}
    parts = [f'--X\r\nContent-Disposition: form-data; name="{k}"\r\n\r\n{v}\r\n'.encode() for k, v in fields.items()]
    parts.append(b'--X\r\nContent-Disposition: form-data; name="photo"; filename="photo.jpg"\r\n\r\n')
    body = b"".join([*parts, photo.read_bytes(), b"\r\n--X--\r\n"])
    job = ask(f"{url}api/v1/jobs", token, "POST", body, "multipart/form-data; boundary=X")
    while job["state"] in ("queued", "running"):
        time.sleep(0.5)
        job = ask(f"{url}api/v1/jobs/{job['id']}", token)
    assert job["state"] == "done", job
    return job["id"]


def configuration(job):
    """What schemathesis is told beside the command line."""
    return f"""
    [checks.negative_data_rejection]
    expected-statuses = {REFUSALS}
    [[operations]]
    include-path-regex = "^/api/v1/jobs/.id."
    include-method = ["GET", "POST"]
    parameters = {{ "path.id" = "{job}" }}
    """


# What the server does once at a time: whoever asks meanwhile is told that it is busy, which schemathesis takes for a fault.
ALONE = ["verify", "list"]


def option(name, operations):
    return [word for operation in operations for word in (f"--{name}-operation-id", operation)]


# Most operations; and one of which a schema does not say all.
PARTS = [
    option("exclude", ["submit", *ALONE]),
    [*option("include", ["submit"]), "--exclude-checks", "positive_data_acceptance"],
]


def check(url, who, token, config, work, part):
    program = pathlib.Path(sys.executable).with_name("schemathesis")
    command = [program, "--config-file", config, "--no-color", "run", f"{url}openapi.json"]
    command += ["--seed", SEED, "--max-examples", EXAMPLES, "--generation-database", "none", "--continue-on-failure"]
    command += ["--request-timeout", "60", "--warnings", "off", *part]
    command += ["--header", f"Authorization: Bearer {token}"] if token else []
    begin = time.monotonic()
    done = subprocess.run(command, cwd=work, capture_output=True, text=True)
    if done.returncode:
        print(f"{done.stdout}{done.stderr}\nFAILED: schemathesis as {who}")
        return False
    cases = next(line for line in done.stdout.splitlines() if "generated" in line).strip()
    print(f"ok  {who}: {cases}, {time.monotonic() - begin:.0f} s", flush=True)
    return True


def main():
    orb, photo = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as work:
        os.environ["ORB_DATA_DIR"] = f"{work}/data"
        tokens = {role: add_account(orb, role) for role in ROLES}
        options = ["--bind", "127.0.0.1:0", "--max-marking", "UNCLASSIFIED", "--device", "cpu"]
        errors = open(f"{work}/errors", "w+")
        server = subprocess.Popen([orb, "serve", *options], stdout=subprocess.PIPE, stderr=errors, text=True)
        try:
            server.stdout.readline()
            url = server.stdout.readline().strip()
            config = pathlib.Path(work, "schemathesis.toml")
            config.write_text(configuration(submit(url, tokens["operator"], photo)))
            everyone = [(who or "nobody", tokens.get(who)) for who in [*ROLES, None]]
            # Whoever asks has one processor's work at it, and the server waits for them.
            with ThreadPoolExecutor(os.cpu_count()) as at_once:
                asked = [at_once.submit(check, url, *who, config, work, part) for part in PARTS for who in everyone]
            passed = [one.result() for one in asked]
            passed += [check(url, *who, config, work, option("include", ALONE)) for who in everyone]
            # As well as before: it answers, and who had an account has it still.
            with urllib.request.urlopen(f"{url}health", timeout=30) as answer:
                assert answer.read() == b"ok\n"
            ask(f"{url}api/v1/jobs", tokens["operator"])
        finally:
            server.send_signal(signal.SIGINT)
            ended = server.wait(timeout=60)
        errors.seek(0)
        said = [line for line in errors if "panicked" in line or "stumbled" in line]
        assert ended == 0 and not said, (ended, said)
        sys.exit(0 if all(passed) else 1)


main()
