"""How many pictures a second `orb view` sends: usage: view_speed.py ORB SCENE [--pictures N]

One connection, one request after the other, another azimuth each time; a table in Markdown: median and 95th percentile of
the time until a picture is whole, pictures a second, bytes of one.
"""
import argparse
import http.client
import statistics
import subprocess
import time
from urllib.parse import urlparse


def main():
    p = argparse.ArgumentParser()
    p.add_argument("orb")
    p.add_argument("scene")
    p.add_argument("--pictures", type=int, default=100)
    args = p.parse_args()
    server = subprocess.Popen([args.orb, "view", args.scene, "--no-open"], stdout=subprocess.PIPE, text=True)
    try:
        server.stdout.readline()
        address = urlparse(server.stdout.readline().strip())
        connection = http.client.HTTPConnection(address.hostname, address.port, timeout=60)
        print("| pixels | moving or at rest | median ms | 95 % ms | pictures/s | kB |\n|---|---|---|---|---|---|")
        for w, h in [(480, 270), (960, 540), (1920, 1080)]:
            for rest in ["false", "true"]:
                took, size = [], 0
                for i in range(args.pictures + 5):
                    began = time.perf_counter()
                    connection.request("GET", f"{address.path}frame?az={360 * i / args.pictures:.2f}&w={w}&h={h}&rest={rest}")
                    answer = connection.getresponse()
                    size = len(answer.read())
                    assert answer.status == 200, answer.status
                    if i >= 5:
                        took.append(1e3 * (time.perf_counter() - began))
                last = sorted(took)[int(0.95 * len(took))]
                what = "at rest" if rest == "true" else "moving"
                print(f"| {w} × {h} | {what} | {statistics.median(took):.1f} | {last:.1f} | {1e3 * len(took) / sum(took):.0f} | {size / 1e3:.0f} |")
    finally:
        server.terminate()


main()
