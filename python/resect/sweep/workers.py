"""Those who run the rows: processes of this machine, or Dask's workers on any machines."""

import concurrent.futures
import multiprocessing
import os

import resect
from resect.sweep.operation import run_row


def processes(jobs, count):
    """Yields results as they come. A process that is lost loses nothing: its rows are run again, up to three times."""
    context = multiprocessing.get_context("spawn")
    left, tries = {job[0]: job for job in jobs}, 0
    while left:
        done_before = len(left)
        pool = concurrent.futures.ProcessPoolExecutor(min(count, len(left)), mp_context=context)
        try:
            # A few rows ahead of the processes: thousands of texts need not be in the queue.
            waiting, due = set(), iter(list(left.values()))
            for job in due:
                waiting.add(pool.submit(run_row, job))
                if len(waiting) >= 2 * count:
                    break
            while waiting:
                done, waiting = concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED)
                for future in done:
                    result = future.result()
                    del left[result["row"]]
                    yield result
                    job = next(due, None)
                    if job:
                        waiting.add(pool.submit(run_row, job))
        except concurrent.futures.process.BrokenProcessPool:
            tries = 0 if len(left) < done_before else tries + 1
            if tries == 3:
                raise resect.Error("the processes ended three times without a result; is there enough memory?") from None
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


def dask(jobs, address, count):
    """The same by Dask. address: of a scheduler, "tcp://host:8786"; or "local" for `count` workers on this machine."""
    try:
        import distributed
    except ImportError:
        raise resect.Error("Dask is not installed; on Debian: apt install python3-distributed") from None
    import logging
    logging.getLogger("distributed").setLevel(logging.ERROR)
    cluster = None
    # Workers import resect as this process does.
    os.environ["PYTHONPATH"] = os.pathsep.join(
        filter(None, [os.path.dirname(os.path.dirname(resect.__file__)), os.environ.get("PYTHONPATH")]))
    if address == "local":
        cluster = distributed.LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=None)
    try:
        client = distributed.Client(cluster or address, timeout=10)
    except (OSError, ValueError) as e:
        raise resect.Error(f"no Dask scheduler answers at {address}: {e}") from None
    try:
        futures = client.map(run_row, jobs, pure=False, retries=5, batch_size=100)
        for future, result in distributed.as_completed(futures, with_results=True):
            future.release()
            yield result
    finally:
        client.close()
        if cluster:
            cluster.close()
