"""What may happen to a checkpoint, or to what it belongs to, between a kill and --resume. Each takes a Trial's maker, does one fault and
checks what was promised."""
import re
import signal

from trial import Failure


def cut_short(make, **drawn):
    """A trial whose render was killed, when it had kept at least a tile or else soon after; it may also have been finished."""
    trial = make(checkpoint=True, **drawn)
    trial.start()
    trial.until(lambda: trial.journal.exists() and trial.journal.stat().st_size > 4096)
    trial.moment(0.5)
    trial.signal(trial.process.pid, signal.SIGKILL)
    code, errors = trial.end()
    trial.given |= trial.half_written()
    trial.check_ended(code, errors, {0, -signal.SIGKILL})
    return trial


def torn(data, layout, rng):
    del data[rng.randrange(len(data)):]


def flipped(data, layout, rng):
    data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)


def flipped_in_head(data, layout, rng):
    data[rng.randrange(layout.head)] ^= 1 << rng.randrange(8)


def lost_block(data, layout, rng):
    """A block of the disk that reads as zeros."""
    start = rng.randrange(len(data)) // 512 * 512
    data[start:start + 512] = bytes(len(data[start:start + 512]))


def grown(data, layout, rng):
    data += rng.randbytes(rng.randint(1, 3 * layout.record))


def emptied(data, layout, rng):
    data.clear()


def shuffled(data, layout, rng):
    """Records in another order, some of them twice."""
    records = [data[i:i + layout.record] for i in range(layout.head, len(data) - layout.record + 1, layout.record)]
    data[layout.head:] = b"".join(rng.choices(records, k=len(records)))


DAMAGES = (torn, flipped, flipped_in_head, lost_block, grown, emptied, shuffled)


def checkpoint_damaged(make):
    """What is damaged is rendered again; a damaged head is refused, and without that checkpoint the render begins anew."""
    trial = cut_short(make)
    layout = trial.journal_layout()
    before = trial.journal.read_bytes()
    data = bytearray(before)
    damage = trial.rng.choice(DAMAGES)
    damage(data, layout, trial.rng)
    trial.journal.write_bytes(data)
    refused = len(data) > 0 and data[:layout.head] != before[:layout.head]
    trial.start("--resume")
    code, errors = trial.end()
    trial.outcome = f"{damage.__name__.replace('_', ' ')}: {code}"
    trial.ran_again = True
    trial.check_ended(code, errors, {1} if refused else {0})
    if refused:
        if "its head is damaged" not in errors:
            raise Failure(f"the message does not say why: {errors.strip()}")
        trial.journal.unlink()
        trial.again()
    else:
        check_warning(errors, damaged_records(before, data, layout))
    return trial


def damaged_records(before, after, layout):
    """How many whole records are none of those that were written."""
    def records(data):
        return [bytes(data[i:i + layout.record]) for i in range(layout.head, len(data) - layout.record + 1, layout.record)]
    good = set(records(before))
    return sum(record not in good for record in records(after))


def check_warning(errors, count):
    told = f"{count} of its tiles were damaged" in errors
    if count > 0 and not told or count == 0 and "damaged" in errors:
        raise Failure(f"{count} records are damaged, and the program says: {errors.strip()!r}")


def checkpoint_replaced(make):
    """By that of another scene, whole or only its records, or by a file that is none."""
    trial = cut_short(make, maker="spheres")
    data = trial.journal.read_bytes()
    layout = trial.journal_layout()
    kind = trial.rng.choice(("another scene's", "another scene's records", "no checkpoint"))
    if kind == "no checkpoint":
        trial.journal.write_bytes(trial.rng.randbytes(trial.rng.randint(1, 100000)))
    else:
        scene = trial.folder / "scene.yarte"
        text = scene.read_bytes()
        scene.write_bytes(text.replace(b" 0.2\n", b" 0.3\n"))
        trial.journal.unlink()
        trial.start()
        trial.end()
        scene.write_bytes(text)
        trial.output.unlink()
        if trial.older:
            trial.output.write_bytes(trial.older)
        if kind == "another scene's records":
            other = trial.journal.read_bytes()
            trial.journal.write_bytes(data[:layout.head] + other[layout.head:])
    refused = kind != "another scene's records"
    trial.start("--resume")
    code, errors = trial.end()
    trial.outcome = f"{kind}: {code}"
    trial.ran_again = True
    trial.check_ended(code, errors, {1} if refused else {0})
    named = {"another scene's": "the scene's text was ", "no checkpoint": "no checkpoint"}.get(kind, "were damaged")
    if named not in errors:
        raise Failure(f"{kind}: the message does not say why: {errors.strip()!r}")
    return trial


def something_altered(make):
    """What the picture depends on is another when the render should go on: that is refused, with what it is. As it was before, the
    render goes on."""
    trial = cut_short(make)
    scene = trial.folder / "scene.yarte"
    # The paper's mesh has faces of more corners: with one moved alone they would not be planar.
    meshes = sorted(trial.folder.glob("*.pmf")) if trial.maker != "paper" else []
    options = {"--size": "99x77", "--samples": "5", "--precision": "fast", "--tile": "48", "--region": "3,4,50,60"}
    kind = trial.rng.choice(("scene", *options, *(("mesh",) if meshes else ())))
    edited = {"scene": scene, "mesh": meshes[0] if meshes else None}.get(kind)
    before = edited.read_bytes() if edited else None
    if kind == "scene":
        scene.write_bytes(before + trial.rng.choice((b"sphere 0 0 0 0.5\n", b"; nothing but a remark\n")))
    elif kind == "mesh":
        vertex = rb"^-?\d+\.\d+ +\S+ +\S+$"
        edited.write_bytes(re.sub(vertex, b"0.125 0.25 0.5", before, count=1, flags=re.MULTILINE))
    kept, asked = trial.journal.read_bytes(), trial.options
    trial.options = asked | ({kind: options[kind]} if kind in options else {})
    trial.start("--resume")
    code, errors = trial.end()
    trial.options = asked
    trial.outcome = f"{kind}: {code}"
    trial.check_ended(code, errors, {1})
    named = {"scene": "the scene's text", "mesh": f"the mesh '{edited.name}'" if edited else "", "--size": "the image's size"}
    named = named.get(kind, kind)
    if f"{named} was " not in errors:
        raise Failure(f"{kind} is altered, and the program says: {errors.strip()!r}")
    if trial.journal.read_bytes() != kept:
        raise Failure("the checkpoint that was refused has changed")
    if edited:
        edited.write_bytes(before)
    trial.again()
    return trial
