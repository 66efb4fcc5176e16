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
    "press": "11e954a4147183af",
    "lift": "a7cd23b67131bdc2",
    "incise": "8f3382dae2707bf2",
    "incise-under-traction": "65b99e29fbb568cc",
    "snip": "fb66a26010bf501f",
    "resect-segment-elastic": "891540278388d7b8",
    "liver-and-gallbladder": "daae647b9d23ebc9",
    "hang": "31f412948e1f3421",
    "drop": "78063ca419057813",
    "bleed": "8a27cf66628f6397",
    "stop-bleeding": "bb220c0236ed1493",
    "transect": "ee6e0f67f685fc47",
    "pringle": "7062479e11a26cda",
    "cautery": "5e1e484b44399e8b",
    "grasp": "bbd04de22e8aef41",
}
