"""What is asked for: the keys of a scene, as keywords."""
import json
import numbers
import os
import re
from collections.abc import Iterable, Mapping

from . import _c

# Keys that go without their section.
SHORT = {'friction': 'law.friction', 'rtol': 'accuracy.rtol',
         **{key: 'slope.' + key for key in
            ('alpha', 'alpha_deg', 'tan_alpha')},
         **{key: 'material.' + key for key in
            ('a', 'b', 'c', 'L', 'R', 'mu_star', 'V_star', 'V_c')}}
PLAIN = re.compile(r'(?!true$|false$|null$)[A-Za-z_][\w.-]*')


def written(value):
    """A value as a scene has it.

    >>> written({'v': [1e-3, float('inf')], 'axes': 'log', 'exact': True})
    '{v: [0.001, inf], axes: log, exact: true}'
    >>> written('10 um')
    '"10 um"'
    """
    if hasattr(value, 'tolist'):  # numpy's
        value = value.tolist()
    if isinstance(value, str):
        return value if PLAIN.fullmatch(value) else json.dumps(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, os.PathLike):
        return written(os.fspath(value))
    if isinstance(value, Mapping):
        return '{' + ', '.join(f'{written(key)}: {written(one)}'
                               for key, one in value.items()) + '}'
    if isinstance(value, Iterable):
        return '[' + ', '.join(map(written, value)) + ']'
    raise TypeError(f'{value!r} is no value of a scene')


def named(keys):
    """Keywords with the sections they belong to; `law` may be a preset's
    name."""
    short = {**SHORT, 'law': 'law.preset'} if isinstance(
        keys.get('law'), str) else SHORT
    return {short.get(key, key): value for key, value in keys.items()
            if value is not None}


def keys_of(**keys):
    """Keywords as {key of a scene: value as a scene has it}."""
    return {key: written(value) for key, value in named(keys).items()}


def scene_of(path, keys):
    """The library's own."""
    if path is None:
        scene = _c.Handle('scene')
        _c.check(_c.library.scene_new(scene.out()))
    else:
        scene = _c.begin('scene', 'read', os.fsencode(path))
    for key, value in keys.items():
        _c.check(_c.library.scene_set(scene, key.encode(), value.encode()))
    return scene
