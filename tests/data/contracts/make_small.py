"""The graphs of real architectures (tiny/), without their weights.

`make_small.py FOLDER` takes graphs with random weights, moves every initialiser of more than 1 KiB out, and writes the
graph beside a line in weights.json that says how to make numbers of the same mean and deviation again: the graphs shrink
from 30 MB to a megabyte, and a test writes the external data itself. Then vectors.json gets what ONNX Runtime computes
with those numbers, by the rule of make_vectors.py.

Element j of tensor t, 32-bit unsigned arithmetic: h = j * 2654435761 + t * 40503 + 12345; h ^= h >> 16; h *= 2246822519;
h ^= h >> 13; value = mean + (h / 2^32 - 0.5) * sqrt(12) * deviation, in 64-bit floats, then rounded to 32 bits.
"""
import glob, json, os, sys, tempfile
import numpy as np, onnx, onnxruntime as ort
from onnx import numpy_helper as nh

here = os.path.dirname(os.path.abspath(__file__))
os.makedirs(here + "/tiny", exist_ok=True)
DIMS = {"num_points": 1, "num_labels": 1, "batch": 1, "height": 252, "width": 252}
SPECIAL = {"vae_encoder_tiny": {"sample": [1, 3, 64, 64]}, "vae_decoder_tiny": {"latent_sample": [1, 4, 16, 16]}}


def numbers(t, count, mean, deviation):
    h = np.arange(count, dtype=np.uint32) * np.uint32(2654435761) + np.uint32((t * 40503 + 12345) & 0xFFFFFFFF)
    h ^= h >> np.uint32(16)
    h *= np.uint32(2246822519)
    h ^= h >> np.uint32(13)
    return (mean + (h.astype(np.float64) / 2.0**32 - 0.5) * np.sqrt(12.0) * deviation).astype(np.float32)


weights, vectors = {}, json.load(open(here + "/vectors.json"))
vectors = {k: v for k, v in vectors.items() if not k.endswith("_tiny")}
for f in sorted(glob.glob(sys.argv[1] + "/*.onnx")):
    name = os.path.splitext(os.path.basename(f))[0]
    model, data, recipe = onnx.load(f), b"", []
    if "depth" in name:
        # With random weights the final ReLU gives nothing but zeros: lift what goes into it.
        last = [n for n in model.graph.node if n.op_type == "Conv"][-1]
        bias = next(i for i in model.graph.initializer if i.name == last.input[2])
        bias.CopyFrom(nh.from_array(nh.to_array(bias) + np.float32(0.5), bias.name))
    for t, tensor in enumerate(model.graph.initializer):
        values = nh.to_array(tensor)
        if values.dtype != np.float32 or values.nbytes <= 1024:
            continue
        mean, deviation = float(np.round(values.mean(), 6)), float(np.round(values.std(), 6))
        made = numbers(t, values.size, mean, deviation)
        tensor.ClearField("raw_data")
        tensor.ClearField("float_data")
        tensor.data_location = onnx.TensorProto.EXTERNAL
        for key, value in (("location", name + ".onnx_data"), ("offset", len(data)), ("length", made.nbytes)):
            entry = tensor.external_data.add()
            entry.key, entry.value = key, str(value)
        data += made.tobytes()
        recipe.append([t, int(values.size), mean, deviation])
    out = f"{here}/tiny/{name}.onnx"
    open(out, "wb").write(model.SerializeToString())
    weights[name] = recipe
    with tempfile.TemporaryDirectory() as folder:
        open(f"{folder}/{name}.onnx_data", "wb").write(data)
        open(f"{folder}/{name}.onnx", "wb").write(model.SerializeToString())
        session = ort.InferenceSession(f"{folder}/{name}.onnx", providers=["CPUExecutionProvider"])
    feed = {}
    for i, a in enumerate(session.get_inputs()):
        shape = SPECIAL.get(name, {}).get(a.name) or [d if isinstance(d, int) else DIMS.get(d, 1) for d in a.shape]
        k = np.arange(int(np.prod(shape)), dtype=np.int64)
        feed[a.name] = (
            np.ones(shape, np.int64)
            if "int64" in a.type
            else (((k * 7919 + 31 * i) % 1000) / 1000).astype(np.float32).reshape(shape)
        )
    results = session.run(None, feed)
    describe = lambda v: {"shape": list(v.shape), "mean": float(v.mean()), "std": float(v.std()), "first": [float(x) for x in v.ravel()[:16]]}
    vectors[name] = {
        "inputs": {k: list(v.shape) for k, v in feed.items()},
        "outputs": {o.name: describe(v) for o, v in zip(session.get_outputs(), results)},
    }
    print(name, os.path.getsize(out), len(data), {k: (round(v["mean"], 4), round(v["std"], 4)) for k, v in list(vectors[name]["outputs"].items())[:3]})
json.dump(weights, open(here + "/tiny/weights.json", "w"))
json.dump(vectors, open(here + "/vectors.json", "w"), indent=1)
