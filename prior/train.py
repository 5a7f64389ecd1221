"""Train SceneNet, DetailNet or SplatNet on endless procedural views.

    torchrun --nproc_per_node=N train.py {scene|splat} --seconds 500 [--total 1000] [--init weights.pt]
    torchrun --nproc_per_node=N train.py detail --rough scene.onnx --init scene.onnx --seconds 500
    python train.py error --init splat.onnx --seconds 200       # what SplatNet expects of its errors, nothing else of it
    python train.py held --init scene.onnx --seconds 600        # what SceneNet says of how the camera was held, nothing else of it

Writes DIR/<net>.pt (everything needed to go on), DIR/<net>_weights.pt (averaged weights, float16, for export.py) and
DIR/<net>.png (the last batch); with a critic also DIR/critic.pt, float16, that another training may begin with. A run that
finds DIR/<net>.pt goes on from there. Progress: one JSON line every 20 s.
The schedule follows the clock, so two runs of one seed see the same data but stop at different steps. A number in the
file DIR/seconds overrides --seconds and --total while it runs: a machine that is lent for less or more than was thought.
"""

import argparse
import functools
import json
import math
import os
import time
import warnings

import torch
import torch.distributed as dist
from torch.nn.parallel import DistributedDataParallel

from critic import Adversary
from levels import hold_levels, settled
from losses import STEPS
from muon import Muon
from nets import NETS, PARTS, Block, Res, load_weights
from packing import FOUR_BITS
from perception import Perception
from pictures import save_sheet
from restore import calibrate, generated_inputs, state_from_onnx
from synth.batches import make_pool

LOG_SECONDS = 20
STOP_EVERY = 20  # steps between two looks at the clock that all ranks share
AVERAGE_EVERY = 4
WARM_UP = 300  # steps
CRITIC_WARM_UP = 800  # steps until a critic counts whole
CRITIC_LR = 3e-4  # its own: it begins late, when the network's is falling
SPIKE = 6  # times the usual gradient: such a step is left out
WHOLE = {"error": "splat", "held": "scene"}  # which network `PARTS` are of


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("net", choices=sorted(STEPS))
    parser.add_argument("--seconds", type=float, default=480, help="length of this run")
    parser.add_argument("--total", type=float, default=0, help="length of the whole schedule, earlier runs included")
    parser.add_argument("--batch", type=int, default=48, help="samples a step and GPU")
    parser.add_argument("--lr", type=float, default=4e-4)
    parser.add_argument("--pool", type=int, default=40000, help="objects a GPU")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--processes", type=int, default=os.cpu_count() or 4, help="for making the pool, all GPUs together"
    )
    parser.add_argument("--dir", default="checkpoints")
    parser.add_argument("--init", default="", help="weights to start from: .pt, or .onnx of this or an older version")
    parser.add_argument("--rough", default="", help="DetailNet: the SceneNet whose masks it makes fine, .onnx")
    parser.add_argument("--critic", type=float, default=0, help="SplatNet: slope of a critic's demand over that of the loss")
    parser.add_argument("--critic-from", type=float, default=0, help="share of the schedule that passes before there is a critic")
    parser.add_argument("--critic-init", default="", help="critic.pt of an earlier training; without it the critic begins anew")
    parser.add_argument("--perception", type=float, default=0, help="SplatNet: weight of how unlike its views look to --eyes, 0.04 for one")
    parser.add_argument("--overlap", type=float, default=0.2, help="SplatNet: weight of its views' silhouettes, 1 - Dice")
    parser.add_argument("--eyes", default="detail.onnx", help="DetailNet's weights, which --perception looks by")
    parser.add_argument("--keep-every", type=float, default=120, help="seconds between two saves of the averaged weights")
    parser.add_argument("--hold", nargs="*", default=[], help="parameters whose names begin so stay as they are, net.mid for one")
    parser.add_argument("--levels", action="store_true", help="SplatNet: what is stored in four bits stays so, scales of groups learn")
    parser.add_argument("--muon", action="store_true", help="matrices inside the network by Muon, AdamW for the rest")
    parser.add_argument("--compile", action="store_true", help="compile the network's blocks first (two minutes, then faster)")
    args = parser.parse_args()
    if args.levels and args.net not in FOUR_BITS:
        parser.error(f"--levels: nothing of {args.net} is stored in four bits")
    return args


class Average:
    """Running average of a network's parameters and buffers, in float32."""

    def __init__(self, net):
        self.state = {k: v.detach().clone().float() for k, v in net.state_dict().items()}

    @torch.no_grad()
    def update(self, net, step):
        decay = min(0.999, (1 + step) / (20 + step))
        for name, value in net.state_dict().items():
            if value.is_floating_point():
                self.state[name].lerp_(value.float(), 1 - decay**AVERAGE_EVERY)
            else:
                self.state[name].copy_(value)

    def half(self):
        return {k: v.half() if v.is_floating_point() else v for k, v in settled(self.state).items()}


def learning_rate(base, step, done):
    """Linear warm-up, then a cosine over the fraction `done` of the schedule, not below 2 %."""
    cosine = 0.5 * (1 + math.cos(math.pi * min(1, done)))
    return base * min(1, (step + 1) / WARM_UP) * max(0.02, cosine)


def smooth(log, figures):
    """Running means of figures, kept on the GPU: reading them would make the host wait for it at every step."""
    for name, value in figures.items():
        log[name] = value.detach() if name not in log else 0.98 * log[name] + 0.02 * value.detach()


def out_of_time(start, seconds, world):
    """Rank 0's clock decides, so that no rank waits for one that has stopped."""
    stop = torch.tensor([float(time.time() - start > seconds)], device="cuda")
    if world > 1:
        dist.broadcast(stop, 0)
    return bool(stop.item())


def told(path, seconds, total):
    """Length of the run and of the whole schedule: the number in the file at `path` if there is one."""
    try:
        with open(path) as file:
            return (float(file.read()),) * 2
    except (OSError, ValueError):
        return seconds, total


def compile_blocks(net):
    """Compile the network's blocks in place, each kind of block once for each shape."""
    torch._dynamo.config.recompile_limit = 64
    # Blocks are small enough for gradients to be shared as they come; cut up for it they do not compile (PyTorch 2.11).
    torch._dynamo.config.optimize_ddp = False
    for module in net.modules():
        if isinstance(module, (Block, Res)):
            module.compile()


def optimizers_of(net, args):
    """What moves the parameters that learn: AdamW, or with --muon two, the matrices of blocks by Muon."""
    learning = [(name, p) for name, p in net.named_parameters() if p.requires_grad]
    inside = {f"{at}.{name}" for at, m in net.named_modules() if isinstance(m, (Block, Res)) for name, _ in m.named_parameters()}
    matrices = [(name, p) for name, p in learning if args.muon and name in inside and p.ndim > 1]
    taken = {name for name, _ in matrices}
    others = [p for name, p in learning if name not in taken]
    adam = torch.optim.AdamW(others, lr=args.lr, weight_decay=0.02, betas=(0.9, 0.98), fused=True)
    # Queries, keys and values are three matrices.
    return [adam, Muon(matrices, args.lr, 0.02, parts={"qkv": 3})] if matrices else [adam]


def train(net, take_step, optimizers, average, adversary, pool, args, spent, step, rank, world):
    """Run the loop for args.seconds. Returns steps done in all, seconds spent in all, and the last picture columns."""
    model = net
    if args.compile:
        compile_blocks(net)
    if world > 1:
        model = DistributedDataParallel(model, device_ids=[rank], broadcast_buffers=False)
    start = logged = kept = time.time()
    seconds, total = args.seconds, args.total or spent + args.seconds
    log = {}
    usual = torch.tensor(1.0, device="cuda")  # size of the gradient
    while True:
        elapsed = time.time() - start
        if step % STOP_EVERY == 0:
            seconds, total = told(os.path.join(args.dir, "seconds"), seconds, total)
        done = (spent + elapsed) / total
        lr = learning_rate(args.lr, step, done)
        for group in (g for o in optimizers for g in o.param_groups):
            group["lr"] = lr
        heed = {}
        if adversary and done >= args.critic_from:
            adversary.follow(CRITIC_LR, min(1, adversary.turns / CRITIC_WARM_UP) * args.critic)
            heed = {"heed": adversary.heeded}
        loss, figures, columns = take_step(model, pool, args.batch, **heed)
        for o in optimizers:
            o.zero_grad(set_to_none=True)
        loss.backward()
        norm = torch.nn.utils.clip_grad_norm_(net.parameters(), 1.0)
        # The optimizers leave the weights as they are where this is 1; no need to look.
        left_out = (~torch.isfinite(norm) | (norm > SPIKE * usual)).float()
        usual = usual.lerp(torch.minimum(norm.nan_to_num(0, 0, 0), 2 * usual), 0.01)
        for o in optimizers:
            o.found_inf = left_out
            o.step()
        step += 1
        if step % AVERAGE_EVERY == 0:
            average.update(net, step)
        smooth(log, figures)
        if step % STOP_EVERY:
            continue
        stop = out_of_time(start, seconds, world)
        if rank == 0 and (stop or time.time() - logged > LOG_SECONDS):
            logged = time.time()
            line = {"it": step, "t": round(spent + elapsed), "samples": step * args.batch * world}
            line["loss"] = round(loss.item(), 4)
            print(json.dumps(line | {k: round(v.item(), 3) for k, v in log.items()}), flush=True)
        if rank == 0 and time.time() - kept > args.keep_every:
            kept = time.time()
            save(net, average, optimizers, adversary, spent + elapsed, step, os.path.join(args.dir, args.net))
        if stop:
            return step, spent + time.time() - start, columns


def save(net, average, optimizers, adversary, spent, step, path):
    """Write `path`.pt, `path`_weights.pt and the critic; whoever reads them meanwhile sees the old ones or the new ones."""
    state = {"net": net.state_dict(), "ema": average.state, "opt": [o.state_dict() for o in optimizers], "spent": spent, "it": step}
    contents = [(path + ".pt", state), (path + "_weights.pt", average.half())]
    if adversary:
        state["critic"] = adversary.state()
        contents.append((os.path.join(os.path.dirname(path), "critic.pt"), adversary.half()))
    for name, content in contents:
        torch.save(content, name + ".new")
        os.replace(name + ".new", name)


def initialised(which, init, hold, levels, pool, masks):
    """The network that `which` trains on the GPU, with the weights of the file `init` if one is given; parameters whose names
    begin as one of `hold` stay as they are, with `levels` so does what is stored in four bits but for the scales. What is new
    in it is the same whatever the seed: of trainings that began alike the mean is a network again."""
    whole = WHOLE.get(which, which)
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(0)
        net = NETS[whole]()
    if init.endswith(".onnx"):
        net.load_state_dict(state_from_onnx(init, net))
        if which != "error":
            calibrate(net.cuda(), generated_inputs(whole, pool, batches=16, masks=masks))
    elif init:
        load_weights(net, init)
    if levels:
        hold_levels(net.cpu(), FOUR_BITS[which])
    net = net.cuda().to(memory_format=torch.channels_last).train()
    for name, parameter in net.named_parameters():
        parameter.requires_grad_(learns(name, which, hold))
    if which in PARTS:
        net.eval()
        net.get_submodule(PARTS[which]).train()
    return net


def learns(name, which, hold):
    """Whether the training of `which` moves the parameter `name`: `PARTS` learn when all else is settled."""
    part = name.split(".")[0]
    ours = part == PARTS[which] if which in PARTS else part not in PARTS.values()
    return ours and not name.startswith(tuple(hold))


def masks_of(path):
    """SceneNet's masks of photos and points, by the weights in the ONNX file at `path`."""
    net = NETS["scene"]()
    net.load_state_dict(state_from_onnx(path, net))
    net = net.cuda().to(memory_format=torch.channels_last).eval()

    @torch.no_grad()
    def masks(x):
        with torch.autocast("cuda", torch.bfloat16):
            return torch.sigmoid(net(x)[0].float())

    return masks


def main():
    args = arguments()
    warnings.simplefilter("ignore")
    rank = int(os.environ.get("LOCAL_RANK", 0))
    world = int(os.environ.get("WORLD_SIZE", 1))
    torch.cuda.set_device(rank)
    if world > 1:
        dist.init_process_group("nccl")
    torch.backends.cuda.matmul.allow_tf32 = True
    torch.backends.cudnn.allow_tf32 = True
    torch.backends.cudnn.benchmark = True
    os.makedirs(args.dir, exist_ok=True)
    path = os.path.join(args.dir, args.net)
    saved = torch.load(path + ".pt", map_location="cuda") if os.path.exists(path + ".pt") else None
    spent, step = (saved["spent"], saved["it"]) if saved else (0, 0)

    # A run that goes on sees other objects than the one before it; no two GPUs see the same.
    stream = args.seed + step
    torch.manual_seed(1000 * stream + rank)
    first_object = 1_000_000 * (64 * stream + rank + 1)
    pool = make_pool(first_object, args.pool, max(2, args.processes // world))

    masks = masks_of(args.rough) if args.net == "detail" else None
    net = initialised(args.net, "" if saved else args.init, args.hold, args.levels, pool, masks)
    average = Average(net)
    optimizers = optimizers_of(net, args)
    adversary = Adversary(args.critic_init) if args.critic and args.net == "splat" else None
    if saved and adversary and "critic" in saved:
        adversary.go_on(saved["critic"])
    if saved:
        net.load_state_dict(saved["net"])
        average.state = saved["ema"]
        for o, state in zip(optimizers, saved["opt"], strict=True):
            o.load_state_dict(state)
    if rank == 0:
        parameters = sum(p.numel() for p in net.parameters())
        print(f"{args.net}: {parameters / 1e6:.1f} M parameters, {len(pool.prims)} objects, step {step}", flush=True)

    take_step = STEPS[args.net]
    if masks:
        take_step = functools.partial(take_step, masks=masks)
    if args.net == "splat":
        take_step = functools.partial(take_step, overlap=args.overlap)
        if args.perception:
            perception = Perception(args.eyes).cuda().to(memory_format=torch.channels_last)
            take_step = functools.partial(take_step, perception=perception, perceived=args.perception)
    step, spent, columns = train(net, take_step, optimizers, average, adversary, pool, args, spent, step, rank, world)
    if rank == 0:
        save(net, average, optimizers, adversary, spent, step, path)
        save_sheet(columns, path + ".png")
        print(f"saved {path}.pt, {path}_weights.pt after {step} steps", flush=True)
    if world > 1:
        dist.barrier()
        dist.destroy_process_group()


if __name__ == "__main__":
    main()
