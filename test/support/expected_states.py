"""The state hash at the end of each scenario, as `resect run NAME` prints it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine.
STILL = {
    "cut": "0f3c6029a542b9c5",
    "cut-120": "0d1c26c4d2bfedd0",
    "cut-950": "774696c2d20c33f0",
    "deform": "fcd58ca8c3c4e15c",
    "deform-120": "692a4559c85a9fe7",
    "deform-950": "0249392e1dbffe15",
    "perforate": "f4c30ae094ca0677",
    "perforate-120": "520c7a03b57a3bcf",
    "perforate-950": "43dccf11c6e61b45",
    "resect-segment": "a5d207d1a59fa471",
}
# On tissue that moves: the same on every machine, with and without vector instructions.
ELASTIC = {
    "press": "c47ed1d7d4a6c3e2",
    "lift": "82cb14e9a56d4b4b",
    "incise": "df9f4705cd62aea5",
    "incise-under-traction": "b914d94608cf8dbd",
    "snip": "dd7f6c30f0640759",
    "resect-segment-elastic": "667fb9e08793aded",
    "liver-and-gallbladder": "233bd38b74245e5d",
    "hang": "4d533e8110c61b0b",
    "drop": "ce319fe7f94823b9",
}
