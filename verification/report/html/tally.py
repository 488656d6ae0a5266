"""What the verdict section counts."""

KINDS = ("ANALYTIC", "EXACT", "EXTERNAL", "CROSS", "REGRESSION")


def share(record):
    """Difference over tolerance; None if the criterion has no such number."""
    difference, tolerance = record["difference"], record["tolerance"]
    if not isinstance(difference, (int, float)) or not isinstance(tolerance, (int, float)) or tolerance <= 0:
        return None
    return difference / tolerance


def by_kind(records, balances=frozenset()):
    """Counts of each kind. `balances` holds the (case, id) of criteria that ask for a balance: those of forces, power, energy and
    heat are no values that a formula gives, so they have a row of their own."""
    rows = []
    for kind in ("ANALYTIC", "balance", *KINDS[1:]):
        of_kind = [record for record in records if kind == ("balance" if (record["case"], record["id"]) in balances else record["kind"])]
        held, failed = (sum(record["verdict"] == word for record in of_kind) for word in ("ok", "failed"))
        rows.append({"kind": kind, "all": len(of_kind), "held": held, "failed": failed, "skipped": len(of_kind) - held - failed})
    return rows


def add_decisions(total, decisions):
    for stage, count in decisions["settled"].items():
        total["settled"][stage] = total["settled"].get(stage, 0) + count
    total["nothing_near"] += decisions["nothing_near"]
    total["double_wrong"] += decisions["double_wrong"]


def over_runs(runs):
    """Sums over the run.json of all runs."""
    total = {"runs": len(runs), "cycles": 0, "cycles_in_contact": 0, "in_contact": 0, "nodes": 0, "without_contact": 0, "interfaces": 0,
             "stopped": 0, "stage_counts": {"settled": {}, "nothing_near": 0, "double_wrong": 0}}
    for run in runs:
        total["cycles"] += run["cycles"]
        total["stopped"] += run["status"] != "completed"
        if "results" not in run:
            raise ValueError(f"the run.json of {run['run_name']} has no results")
        total["interfaces"] += len(run["results"])
        for result in run["results"]:
            contact = result["contact"]
            total["cycles_in_contact"] += contact["cycles_in_contact"]
            total["in_contact"] += contact["most_in_contact"]
            total["nodes"] += contact["secondary_nodes"]
            add_decisions(total["stage_counts"], result["decisions"])
        total["without_contact"] += all(result["contact"]["most_in_contact"] == 0 for result in run["results"])
    total["stage_counts"]["decided"] = sum(total["stage_counts"]["settled"].values())
    return total


def nearest(records, most=12):
    """The criteria that come closest to their tolerance."""
    known = [(share(record), record) for record in records if share(record) is not None]
    return [record | {"share": part} for part, record in sorted(known, key=lambda item: -item[0])[:most]]


def mutation(found):
    """Score of the mutations; None if there are none."""
    rows = (found or {}).get("mutations", [])
    if not rows:
        return None
    red = sum(bool(row.get("red")) for row in rows)
    return {"rows": rows, "red": red, "all": len(rows)}
