"""site_below.py PREFIX -- prints where this python looks for modules below
PREFIX/lib, or nothing.  Debian's looks in dist-packages of /usr/local and in
site-packages of ~/.local, a virtual environment in its own."""
import site
import sys

folders = [*site.getsitepackages(), site.getusersitepackages()]
print(next((folder for folder in folders
            if folder.startswith(sys.argv[1] + '/lib/')), ''))
