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
    "press": "b5f779fca02d11ea",
    "lift": "aa9e09533d9c094a",
    "incise": "50471cee3793a47e",
    "incise-under-traction": "784e795b4b337fc9",
    "snip": "b11ff22c44489c95",
    "resect-segment-elastic": "ce3fcfe105496d34",
    "liver-and-gallbladder": "d3958364dc170441",
    "hang": "58bd4eaf6b4c0c63",
    "drop": "99c1800ebd2ad1d0",
}
