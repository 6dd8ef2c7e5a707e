"""A scene and its twin beside `units: si`: what makes the numbers of one those
of the other."""
import math
import re

from cli_room import expect

V, L = 4e-7, 3e-6
MATERIAL = f'material: {{V_star: {V}, L: {L}}}\n'
FACTOR = {'V_star': ('m/s', V), 'L': ('m', L), 'L/V_star': ('s', L / V),
          'V_star/L': ('1/s', V / L)}
SHIFT = {'ln(V_star)': ('ln(m/s)', math.log(V)),
         'log10(V_star/L)': ('log10(1/s)', math.log10(V / L))}
# Of each law: phi of psi = 1, its unit, whether psi is a logarithm.
PHI = {'dieterich_gen': (L / V, 's', False),
       'spinodal_gen': (1 / 101, '1', False),
       'kato_tullis': (L / V, 's', False),
       'perrin': (2 * L / V, 's', True)}
STATES = {'psi', 'psi_at_v0', 'psi_sp0', 'psi_kick'}
PRODUCTS = ('products=[equilibria, folds, knees, estimates, sensitivities, '
            'taylor_series, friction_law, spring_block, bifurcation, '
            'fold_curves, chi, basins]')
SMALL = ['--set', 'basins.cells=[8, 8]', '--set', 'basins.audit=4']
SWEEP = ('sweep={key: slope.alpha, from: 0.3, to: 0.36, points: 3}')
COMMANDS = [
    ['knees'], ['study', '--set', PRODUCTS, *SMALL], ['basin', *SMALL],
    ['portrait', '--sensitivities'],
    ['push', '--v', '1000 V_star'], ['push', '--v', '1 V_star'],
    ['simulate', '--v', '1000 V_star'],
]


class Twins:
    """Two trees of JSON, their units beside them."""

    def __init__(self, law):
        self.law = law
        self.compared = 0
        self.told = 0

    def unit(self, name, unit):
        """Name, unit, and what makes the other number of one."""
        phi_1, s, is_log = PHI[self.law]
        if name in STATES:
            other = name.replace('psi', 'phi')
            if name == 'psi_kick':
                return other, None, math.exp if is_log else lambda x: x
            unit_told = None if s == '1' else s
            if is_log:
                return other, unit_told, lambda x: phi_1 * math.exp(x)
            return other, unit_told, lambda x: phi_1 * x
        if unit in FACTOR:
            told, factor = FACTOR[unit]
            return name, told, lambda x: x * factor
        if unit in SHIFT:
            told, shift = SHIFT[unit]
            return name, told, lambda x: x + shift
        return name, unit, lambda x: x

    def same(self, where, made, own, si, bars):
        if own is None or si is None:
            expect(own is None and si is None or own is not None
                   and not 1e-300 < abs(made(own)) < 1e300, where, own, si)
            return
        wanted = made(own)
        expect(abs(wanted - si) <= bars + 1e-13 * max(abs(wanted), abs(si))
               + 1e-15, where, own, wanted, si)
        self.compared += 1
        self.told += wanted != own

    def numbers(self, where, made, own, si):
        """A number, or one with its bar; a list of them; a word."""
        if isinstance(own, list):
            expect(len(own) == len(si), where)
            for a, b in zip(own, si):
                self.numbers(where, made, a, b)
        elif isinstance(own, dict):
            if own['value'] is None or si['value'] is None:
                expect(own.get('reason') == si.get('reason')
                       or 'largest double' in si['reason'], where, own, si)
                return
            width = own['error']
            both = abs(made(own['value'] + width) - made(own['value'] - width))
            self.same(where, made, own['value'], si['value'],
                      both + si['error'])
            expect(si['error'] >= 0.49 * both * (1 - 1e-6) - 1e-13 *
                   abs(si['value']), where, own, si)
        elif isinstance(own, (int, float)) and not isinstance(own, bool):
            self.same(where, made, own, si, 0)
        else:
            expect(own == si, where, own, si)

    def member(self, where, name, own, si, units, told):
        kind = units.get(name) if isinstance(units, dict) else None
        other, unit, made = self.unit(name, kind if isinstance(kind, str)
                                      else None)
        where = f'{where}.{name}'
        expect(other in si, where, 'is not', sorted(si))
        if name == 'level' and isinstance(kind, dict):
            return
        quantity = isinstance(own[name], dict) and 'value' in own[name]
        leaf = (quantity or not isinstance(own[name], (dict, list)) or
                isinstance(own[name], list) and
                not (own[name] and isinstance(own[name][0], dict)
                     and 'value' not in own[name][0]))
        if not leaf:
            self.walk(where, own[name], si[other], kind or {},
                      told.get(other) or {})
            return
        if own[name] != []:
            expect(told.get(other) == unit, where, unit, told)
        self.numbers(where, made, own[name], si[other])

    def walk(self, where, own, si, units, told):
        if isinstance(own, list):
            expect(len(own) == len(si), where, own, si)
            for a, b in zip(own, si):
                self.walk(where, a, b, units, told)
            return
        expect(len(own) == len(si), where, sorted(own), sorted(si))
        for name in own:
            if name not in ('units', 'cost'):
                self.member(where, name, own, si, units, told)
        for row in [own] if 'level' in own else []:
            level = units['level'].get(row['what'])
            if row['what'] == 'psi_level':
                return
            _, unit, made = self.unit('level', level)
            expect(told['level'].get(row['what']) == unit, where, told)
            self.numbers(where + '.level', made, own['level'], si['level'])


def scene(law, units=''):
    rate = V if 'si' in units else 1
    cut = f', V_c: {1e4 * rate}' if law == 'kato_tullis' else ''
    return (f'law: {{preset: {law}}}\nslope: {{alpha: 0.34}}\n'
            f'{MATERIAL[:-2]}{cut}}}\n{units}')


def pair(room, law, command, *more):
    """Both files, and the arguments for each."""
    room.write('own.yaml', scene(law))
    room.write('si.yaml', scene(law, 'units: si\n'))
    phi_1, _, is_log = PHI[law]
    psi = 1.5
    phi = phi_1 * (math.exp(psi) if is_log else psi)
    args = [command[0], *command[1:], *more]
    state = '--v' in command
    return ([args[0], 'own.yaml', *args[1:],
             *(['--psi', repr(psi)] if state else [])],
            [args[0], 'si.yaml', *args[1:],
             *(['--phi', repr(phi)] if state else [])])


def state_of(law):
    """phi of psi."""
    phi_1, _, is_log = PHI[law]
    return lambda x: phi_1 * (math.exp(x) if is_log else x)


def sweep_member(twins, law, name, value, told, units, units_told):
    """A number over the points, or a map: its values and their bars."""
    state = re.search(r'(ln_)?psi(_at_v0|_sp0)?$', name)
    unit = units.get(name)
    phi_1, s, _ = PHI[law]
    if state and name not in told:
        other = name[:state.start()] + state.group().replace('psi', 'phi')
        expect(units_told.get(other, '1') == (
            ('ln(s)' if s == 's' else '1') if state.group(1) else s), other,
               units_told)

        made = state_of(law)
        if state.group(1):
            def made(x):
                return x + math.log(phi_1)
    else:
        other, unit_told, made = twins.unit(name, unit)
        expect(units_told.get(other) == unit_told, name, unit, units_told)
    own, si = value, told[other]
    if not isinstance(own, dict):
        twins.numbers(name, made, own, si)
        return
    for part in ('value', 'least', 'greatest'):
        if part in own:
            error = own.get('error', 0), si.get('error', 0)
            sweep_numbers(twins, name, made, own[part], si[part], *error)
    for part in own:
        if part == 'dims':
            expect(own[part] == [x.replace('phi', 'psi') for x in si[part]],
                   name)
        elif part not in ('value', 'error', 'least', 'greatest'):
            expect(own[part] == si[part], name, part)


def sweep_numbers(twins, where, made, own, si, error, error_told):
    if isinstance(own, list):
        expect(len(own) == len(si), where)
        for i, (a, b) in enumerate(zip(own, si)):
            bar = (e[i] if isinstance(e, list) else e
                   for e in (error, error_told))
            sweep_numbers(twins, where, made, a, b, *bar)
    elif isinstance(own, (int, float)):
        bars = (error or 0, error_told or 0)
        both = abs(made(own + bars[0]) - made(own - bars[0]))
        twins.same(where, made, own, si, both + bars[1])
    else:
        expect(own == si, where, own, si)
