"""The state hash at the end of each scenario, as `resect run NAME` prints it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine.
STILL = {
    "cut": "85b7ae99459ba6f4",
    "cut-120": "724719e4f75f5d41",
    "cut-950": "b506b1d8f618f8b2",
    "deform": "8ec8deb7d1c72725",
    "deform-120": "89246ecb21207e7d",
    "deform-950": "3e48644c42feffab",
    "perforate": "16a8fa21368e019a",
    "perforate-120": "2cc03e09187f2e26",
    "perforate-950": "0b2776e5fbe48bc8",
    "resect-segment": "10d1ba46edd0a63b",
}
# On tissue that moves: the same on every machine, with and without vector instructions.
ELASTIC = {
    "press": "6be638f603e8c86c",
    "lift": "462218c7b5e6737e",
    "incise": "2e6bf457e151b8d9",
    "incise-under-traction": "32952fa3556d0da3",
    "snip": "4f29a6872b4524b7",
    "resect-segment-elastic": "f55fff773c2c46c1",
    "liver-and-gallbladder": "2b2d52520195873a",
    "hang": "636585395a1a15c7",
    "drop": "0ea40c3808831b7b",
    "bleed": "a8b53e5ec0f030d9",
    "stop-bleeding": "0b8b38e9fb316ad2",
    "transect": "683a3f44ad08ba37",
    "pringle": "94248d2f17f75dd2",
    "cautery": "6001466ba2c3af3d",
}
