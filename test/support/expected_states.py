"""The state hash at the end of each scenario, as `resect run NAME` prints it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine.
STILL = {
    "cut": "9e99ec3178c76049",
    "cut-120": "30f0e2c56b8c2318",
    "cut-950": "f026506decec082e",
    "deform": "bfc614f1b441eba2",
    "deform-120": "8faf3a1a4fc18aff",
    "deform-950": "72ab4f4172f4b6d7",
    "perforate": "939825cf0f08ee98",
    "perforate-120": "412536caa5de2856",
    "perforate-950": "b6eee4a1389049bd",
    "resect-segment": "6622500122147aa5",
}
# On tissue that moves: the same on every machine, with and without vector instructions.
ELASTIC = {
    "press": "ed62b3e856f7a6af",
    "lift": "171d99b2a46fe6ed",
    "incise": "59b4c044ac991fb6",
    "incise-under-traction": "024cd5e0d31424a9",
    "snip": "22d4a9da942311c4",
    "resect-segment-elastic": "8af25c30c87f1aea",
    "liver-and-gallbladder": "97b2c9861f490c08",
    "hang": "864ab967330c4543",
    "drop": "7c1f65d25f2e5eae",
    "bleed": "61a10036c0b2c611",
    "stop-bleeding": "8b62f911390be3fa",
    "transect": "f48301961425586d",
    "bare-clip-divide": "29bf362d837a3454",
    "pringle": "15c33a19fbcba413",
    "cautery": "ddb66d1ff68af361",
    "grasp": "56b6d254c9c796de",
}
