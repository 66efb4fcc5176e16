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
    "lift": "a435b67df4ea5554",
    "incise": "c5f80e535763c3d1",
    "incise-under-traction": "508de1e96981d5c4",
    "snip": "9aae3c36d5ebe5f2",
    "resect-segment-elastic": "cb3953c9e4c17a2f",
    "liver-and-gallbladder": "daae647b9d23ebc9",
    "hang": "31f412948e1f3421",
    "drop": "78063ca419057813",
    "bleed": "01a27d0d0a4c7cf3",
    "stop-bleeding": "ccc1a6572dba6a78",
    "transect": "e1630622a4425ef7",
    "pringle": "615bb4f9097bad2d",
    "cautery": "e19ae824262ae7b4",
    "grasp": "e9ec0f0381cc686f",
}
