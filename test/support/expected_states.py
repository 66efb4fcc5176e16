"""Which state does each scenario end in? As `resect run NAME` says it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine of this kind.
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
# On tissue that moves: the same with and without vector instructions.
ELASTIC = {
    "press": "94cdb8b39fcf6f12",
    "lift": "6f503c65b783c800",
    "incise": "9e2beca103d94d4f",
    "incise-under-traction": "6dd5c7daa220766e",
    "snip": "4e1df3c5351b4608",
    "resect-segment-elastic": "9adfba252cea5bc9",
    "liver-and-gallbladder": "10cb80808d9f217c",
    "hang": "f514851576592b71",
    "drop": "4b5b317bc9bba7e4",
}
