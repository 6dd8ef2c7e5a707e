"""A wheel of the module and the library that was built (PEP 517): of
$SLIPWAY_LIBRARY, else of build/lib.  It needs no compiler and no other
package."""
import base64
import ctypes
import hashlib
import os
import pathlib
import sysconfig
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
BUILT = HERE.parent.parent / 'build' / 'lib' / 'libslipway.so.0'
METADATA = '''Metadata-Version: 2.1
Name: slipway
Version: {version}
Summary: Phase planes of rate-and-state friction
License: GPL-3.0-or-later
Requires-Python: >=3.9
'''
WHEEL = '''Wheel-Version: 1.0
Generator: slipway
Root-Is-Purelib: false
Tag: {tag}
'''


def version_of(library):
    version = ctypes.CDLL(str(library)).slipway_version
    version.restype = ctypes.c_char_p
    return version().decode()


def digest(data):
    found = base64.urlsafe_b64encode(hashlib.sha256(data).digest())
    return 'sha256=' + found.decode().rstrip('=')


def build_wheel(folder, config_settings=None, metadata_directory=None):
    library = pathlib.Path(os.environ.get('SLIPWAY_LIBRARY', BUILT))
    if not library.is_file():
        raise SystemExit(f'slipway: no {library}, expected the library that '
                         '`ninja -C build` makes, or its path in '
                         '$SLIPWAY_LIBRARY')
    version = version_of(library)
    tag = 'py3-none-' + sysconfig.get_platform().replace('-', '_').replace(
        '.', '_')
    info = f'slipway-{version}.dist-info'
    files = {f'slipway/{path.name}': path.read_bytes()
             for path in sorted(HERE.glob('slipway/*.py'))}
    files['slipway/libslipway.so.0'] = library.read_bytes()
    files[f'{info}/METADATA'] = METADATA.format(version=version).encode()
    files[f'{info}/WHEEL'] = WHEEL.format(tag=tag).encode()
    record = ''.join(f'{name},{digest(data)},{len(data)}\n'
                     for name, data in files.items())
    files[f'{info}/RECORD'] = f'{record}{info}/RECORD,,\n'.encode()
    name = f'slipway-{version}-{tag}.whl'
    with zipfile.ZipFile(os.path.join(folder, name), 'w',
                         zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            wheel.writestr(path, data)
    return name
