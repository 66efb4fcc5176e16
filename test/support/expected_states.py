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
    "lift": "4e5ceaaea296b595",
    "incise": "ca024496abd75c9d",
    "incise-under-traction": "5b9fcb29fa55d46a",
    "snip": "7720011b75ad388c",
    "resect-segment-elastic": "2ddd52ef16215091",
    "liver-and-gallbladder": "daae647b9d23ebc9",
    "hang": "31f412948e1f3421",
    "drop": "78063ca419057813",
    "bleed": "299f1b7744d5eaf9",
    "stop-bleeding": "58cfb660184d32ce",
    "transect": "f9fd3b69867d2029",
    "pringle": "08f000e11a044219",
    "cautery": "670e372195441554",
    "grasp": "a95297b160183f99",
}
