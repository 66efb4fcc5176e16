"""The state hash at the end of each scenario, as `resect run NAME` prints it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine.
STILL = {
    "cut": "b8c3913d2ff0cee5",
    "cut-120": "28aedf1be9f418ac",
    "cut-950": "9f11763aa5e54e3b",
    "deform": "87bda2239206e71b",
    "deform-120": "0f40d3af4a92f21e",
    "deform-950": "85dbe0c97bc162a0",
    "perforate": "ca51a43cd32b47d5",
    "perforate-120": "f1884a5d611aca3e",
    "perforate-950": "b45bea083466915b",
    "resect-segment": "231ec578fc72eec5",
}
# On tissue that moves: the same on every machine, with and without vector instructions.
ELASTIC = {
    "press": "f06277be78f9e23a",
    "lift": "724e5337bc5a2a7d",
    "incise": "8fa6abda0a0e06ad",
    "incise-under-traction": "1b6bed0d9965a331",
    "snip": "443b6f63143a9d97",
    "resect-segment-elastic": "71e14ce6ed1f60a1",
    "liver-and-gallbladder": "274f9cbf9480c4fe",
    "hang": "1758851e84e7ca51",
    "drop": "382667b744791359",
}
