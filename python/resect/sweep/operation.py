"""One operation of a sweep, from the text of its scenario to its row of results."""

import time

import resect

#: Results of every operation, in the order of the table.
RESULTS = ("frames", "simulated_s", "particles", "removed_ml", "pieces", "piece_ml", "cut_cm2", "severed", "torn",
           "bled_ml", "faults")


def run_text(text, name):
    """Results, forces and the state hash of a scenario, as a dictionary; numbers are rounded as the table shows them."""
    begin = time.perf_counter()
    scenario = resect.Scenario.parse(text, name)
    simulation = resect.Simulation(scenario)
    report = resect.Report()
    severed = torn = faults = 0
    peak = [0.0] * simulation.tool_count
    for frame in range(scenario.frame_count):
        simulation.step(scenario.inputs(frame), report=report)
        severed, torn, faults = severed + report.severed, torn + report.torn, faults + len(report.faults)
        for tool, force in enumerate(report.tool_force):
            peak[tool] = max(peak[tool], float((force @ force)**0.5))
    ledger = simulation.ledger()
    values = (simulation.frame, simulation.time, ledger["before"]["particles"], ledger["removed"]["ml"],
              ledger["piece_count"], ledger["pieces"]["ml"], ledger["cut_cm2"], severed, torn, report.bled_ml, faults)
    result = {name: value if isinstance(value, int) else float(f"{value:.9g}") for name, value in zip(RESULTS, values)}
    names = [f"peak_force_n.{model}" for model in scenario.tools]
    for tool, column in enumerate(names):
        if names.count(column) > 1:
            column += f".{tool}"
        result[column] = float(f"{peak[tool]:.9g}")
    result["state_hash"] = f"{simulation.state_hash:016x}"
    result["seconds"] = round(time.perf_counter() - begin, 3)
    return result


def run_row(job):
    """job: (number of the row, its setup's digest, text of the scenario). Never raises: a row that cannot be run says why."""
    number, setup, text = job
    try:
        return {"row": number, "setup": setup, **run_text(text, f"row {number}"), "error": ""}
    except resect.Error as e:
        return {"row": number, "setup": setup, "error": str(e)}
