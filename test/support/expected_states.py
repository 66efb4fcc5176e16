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
    "press": "1078134ceb30d4f6",
    "lift": "cf3cb36ea82d6919",
    "incise": "f5b195e8166a7b6e",
    "incise-under-traction": "bf2839ee1c5cd9de",
    "snip": "29274475cb018fb9",
    "resect-segment-elastic": "518dd0588379c8fa",
    "liver-and-gallbladder": "8b3b12b0cd6e0c1b",
    "hang": "a86900fcd006aec7",
    "drop": "9aff9527640bd92e",
}
