"""A kernel of PyTorch tensors, on the CPU or a GPU.

    python3 tensors.py [TRIALS]
"""
# %%
import sys

import torch

import axiscert as ax

device = "cpu"  # on a GPU: "cuda"


# %% Arrays come as tensors.
# This one bounds the triangle by a box and asks whether the sphere touches that: fast, and over the reals never a missed contact.
def bounding_box(a, b, c, p, r):
    a, b, c, p, r = (tensor.to(device) for tensor in (a, b, c, p, r))
    low, high = torch.minimum(torch.minimum(a, b), c), torch.maximum(torch.maximum(a, b), c)
    away = p - torch.minimum(torch.maximum(p, low), high)
    return ((away * away).sum(dim=1) <= r * r).cpu()


kernel = ax.kernel(bounding_box, tensors=torch.from_dlpack)

# %% How often does it invent a contact, and does rounding make it miss one?
record = ax.judge(kernel, family=["general", "tangent", "scene-walk"], trials=int((sys.argv + [20000])[1]), require="conservative")
print(record)
print(f"{kernel.calls} calls, {kernel.seconds:.2f} s of them in the kernel itself")
