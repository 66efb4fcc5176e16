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
    "press": "9e6f30b53c1738dc",
    "lift": "fed6653e59ccb3c9",
    "incise": "d9c3e97c84e2b945",
    "incise-under-traction": "1487056a273c4352",
    "snip": "067f02e5b5db011e",
    "resect-segment-elastic": "e4c2cbfac6190a15",
    "liver-and-gallbladder": "18da989316eac91f",
    "hang": "f73b9705748bb596",
    "drop": "a9194c745cabe7d7",
}
