"""Faults by signals: to workers, to the parent, to all. Each takes a Trial's maker, does one fault and checks what was promised."""
import pathlib
import signal
import time

from trial import Failure


def end_after_kills(trial, kills):
    """Exit code 3 is for a tile whose worker died twice, or for workers that die before they take one: not after one kill."""
    code, errors = trial.end_or_again({0, 3} if kills > 1 else {0})
    if code == 3 and "died twice" not in errors and "keep dying" not in errors:
        raise Failure(errors)
    return trial


def worker_killed(make):
    trial = make()
    trial.start()
    trial.moment_of_work(0.8)
    return end_after_kills(trial, trial.signal(trial.any_worker(), signal.SIGKILL))


def workers_killed_in_turn(make):
    trial = make()
    trial.start()
    times = trial.rng.randint(2, 4)
    kills = 0
    for _ in range(times):
        trial.moment_of_work(1 / times)
        kills += trial.signal(trial.any_worker(), signal.SIGKILL)
    return end_after_kills(trial, kills)


def workers_killed_at_once(make):
    trial = make()
    trial.start()
    trial.moment_of_work(0.8)
    return end_after_kills(trial, sum(trial.signal(worker, signal.SIGKILL) for worker in trial.workers()))


def successors_killed(make):
    """A worker, whoever takes its place, whoever takes that one's …"""
    trial = make()
    trial.start()
    trial.moment_of_work(0.5)
    known = set(trial.workers())
    victim = trial.any_worker()
    kills = 0
    for _ in range(trial.rng.randint(2, 6)):
        kills += trial.signal(victim, signal.SIGKILL)
        trial.until(lambda: set(trial.workers()) - known)
        victim = next((worker for worker in trial.workers() if worker not in known), None)
        known.add(victim)
        trial.moment(0.05)
    return end_after_kills(trial, kills)


def worker_stopped(make):
    """For longer than a worker may be."""
    trial = make()
    trial.start()
    trial.moment_of_work(0.6)
    trial.signal(trial.any_worker(), signal.SIGSTOP)
    return end_after_kills(trial, 0)


def worker_paused(make):
    trial = make()
    trial.start()
    trial.moment_of_work(0.8)
    worker = trial.any_worker()
    if trial.signal(worker, signal.SIGSTOP):
        time.sleep(trial.rng.uniform(0, 0.3))
        trial.signal(worker, signal.SIGCONT)
    return end_after_kills(trial, 0)


def all_paused(make):
    """As by Ctrl-Z and `fg`."""
    trial = make()
    trial.start()
    trial.moment()
    if trial.signal_all(signal.SIGSTOP):
        time.sleep(trial.rng.uniform(0, 0.3))
        trial.signal_all(signal.SIGCONT)
    return end_after_kills(trial, 0)


def parent_killed(make):
    """So may be the one that goes on, and the next."""
    trial = make()
    for run in range(trial.rng.randint(1, 3)):
        trial.start(*(["--resume"] if trial.journal and run > 0 else []))
        kill_parent(trial, trial.moment)
    trial.again()
    return trial


def parent_killed_writing(make):
    trial = make()
    trial.start()
    kill_parent(trial, trial.moment_of_writing)
    trial.again()
    return trial


def kill_parent(trial, wait):
    wait()
    trial.signal(trial.process.pid, signal.SIGKILL)
    code, errors = trial.end()
    # Nobody is there to remove the file that was to become the output; but there is one at most.
    left = trial.half_written() - trial.given
    if code == -signal.SIGKILL and len(left) < 2:
        trial.given |= left
    trial.check_ended(code, errors, {0, -signal.SIGKILL})


def interrupted(make):
    trial = make()
    return interrupt(trial, trial.moment)


def interrupted_writing(make):
    trial = make()
    return interrupt(trial, trial.moment_of_writing)


def interrupt(trial, wait):
    """The parent alone, as by `kill`, or all, as from a terminal or a service manager."""
    number = trial.rng.choice((signal.SIGINT, signal.SIGTERM))
    send = trial.rng.choice((lambda: trial.signal(trial.process.pid, number), lambda: trial.signal_all(number)))
    trial.start()
    wait()
    handled = handles(trial.process.pid, number)
    send()
    code, errors = trial.end()
    # Before the program has its handlers, the signal itself ends it.
    trial.check_ended(code, errors, {0, 128 + number} if handled else {0, 128 + number, -number})
    if code != 0:
        trial.again()
    return trial


def handles(pid, number):
    try:
        status = pathlib.Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return False
    caught = next((line.split()[1] for line in status.splitlines() if line.startswith("SigCgt:")), "0")
    return bool(int(caught, 16) >> (number - 1) & 1)
