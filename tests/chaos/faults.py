"""The faults: what each is called, and how often it is drawn, of a hundred or so; those that wait for seconds less often."""
import checkpoints
import signals
import surroundings

FAULTS = {
    "a worker is killed": (signals.worker_killed, 8),
    "workers are killed one after the other": (signals.workers_killed_in_turn, 6),
    "all workers are killed at once": (signals.workers_killed_at_once, 6),
    "a worker is killed, and those who take its place": (signals.successors_killed, 6),
    "a worker is stopped": (signals.worker_stopped, 2),
    "a worker is stopped and continued": (signals.worker_paused, 5),
    "all are stopped and continued": (signals.all_paused, 4),
    "the parent is killed": (signals.parent_killed, 12),
    "the parent is killed while it writes": (signals.parent_killed_writing, 4),
    "SIGINT or SIGTERM": (signals.interrupted, 8),
    "SIGINT or SIGTERM while it writes": (signals.interrupted_writing, 3),
    "files may not grow beyond some size": (surroundings.file_too_large, 6),
    "the disk is full: output": (surroundings.full_for_output, 3),
    "the disk is full: checkpoint": (surroundings.full_for_checkpoint, 3),
    "the disk is full: both": (surroundings.full_for_both, 3),
    "an output is /dev/full": (surroundings.no_device_space, 1),
    "little memory from the start": (surroundings.little_memory, 5),
    "workers get no more memory": (surroundings.workers_without_memory, 5),
    "the output's folder is lost": (surroundings.folder_lost, 5),
    "the clock jumps by hours": (surroundings.clock_jumps, 4),
    "the checkpoint is damaged": (checkpoints.checkpoint_damaged, 10),
    "the checkpoint is replaced": (checkpoints.checkpoint_replaced, 4),
    "the scene, a mesh or an option is altered": (checkpoints.something_altered, 8),
}

# Not with sanitizers: they reserve terabytes of addresses, and want to be loaded first.
NOT_SANITIZED = (surroundings.little_memory, surroundings.workers_without_memory, surroundings.clock_jumps)
