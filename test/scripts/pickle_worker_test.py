#!/usr/bin/python3
"""python/bin/pickle_worker: pickles that it reads, and pickles that it rejects."""
import array
import base64
import importlib.machinery
import importlib.util
import json
import os
import pickle
import resource
import socket
import struct
import subprocess
import tempfile
import unittest
import zlib
from pathlib import Path

PROGRAM = Path(__file__).resolve().parents[2] / 'python' / 'bin' / 'pickle_worker'

# What pickle.dumps() of Python 3.11 gives for VALUES with NumPy as named, by zlib and base85:
# {'a': [1, -2, 3000, 2**40, True, None, 'é'], 'f': 1.5, 'm': np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]),
#  'o': np.array([[1, 2], [3, 4]], dtype='>i2', order='F'), 'b': np.array([True, False]), 's': {'x'}, 't': (1,),
#  'u': np.array(['ab', 'c']), 'n': np.float32(0.5), 'e': np.zeros((0, 2)), 'same': the array of 'm'}
DUMPED = {
    '1.24.2, protocol 2':
        b'c-nQ6TXWJt7>1XCNK>__sP%kS>H!6-R;>k(Rbo+Bt9Zan62gQT2z`^yjLhhaH&F1Oc;{vB`=`7TcQ?sJr{m5f-)?rZ&-3lKKa}qv`Fes'
        b'7Vj$6glGhT|zmv&iWn=nhnuwMd)#?h5o4=5><;oUP%jG|ElE@ET?6BORyVfsQJ<l$5gAQvOo@ew`-LtKp>oYH~n2L0`N_CszEOu&SfQ+'
        b'SEy{2vXs_lx7iYd9P3AHX1ItFXIMNAK|i(>aW_E5}lO-<2~Lu8{Zo2<Xa|J*B8TMO7X9<5_PMJ}%;<!*~OP^;CdJhh2@X@udRId-P%MH'
        b'08o-{q)R2}34|*(m0sI9tIXhYQV89A-FTN<t4uowOrUI_7ZC;}j=CPi2UcPN>!{;gnE2O>rhxTf*6GYUj)mSIfu(kR(w^3g-p!0>wp!y'
        b'cwO)Tui(qh?gm@Na6rjBc54ALGZ3oT#tF*P~65V$)ivt4mSj8p5i9Mt&rs7wx#Q4(B_qObzSvsUe1LE?#S7%xN8h>k77{{8SZO|0hZ(-'
        b'Ksk1-2*(E$4<pA%k>hF!kA>qCil^Ms5rxt+T1v|>EK9GfxSt{${#a3o@Jv`fr>HV$p{0u#|G9_0WpoTr#Y%*1&7&reFDYKd$gKzR+T`3'
        b'+h$@2$)*FhqL#$G~lQbLe<IL(Jvkw#>MP@|Q`;(I!Z#glu&um}C=Q)Z7!xvNT?HgSix-%0L{sG!Y0XF',
    '2.4.6, protocol 4':
        b'c-nQ5%}T>S6oqG|X^m8|h!!8AtD@q<h1fzCLI<-D1UFKWG$n;5E%^Zp3T|3kxuDSNL-+>neIb{wjFXvwrNn`mvzU9obLP&Y_IAUFTo2d'
        b')YT+$5IPLtTX?poleXhtWIyZrRzM~7Yj~A_P)d18-s0WEZo;178D0G{CGK>dS7+MpAt#0T#qacdI#EEf<P?nVl8$nN%ERmBb8q~%oyvk'
        b'fT<E0sTn^5k>ld+pMvHmG8=IXu#^bAeY?1*fsJUEHbUKoce&sR$+X)Dolt>wCx>p>eu8_*GYx>wCIc-wyom`Jb-Y;e5ldtTr>H*`Wti7'
        b'=umo?XP7N}7GNO1m$71*1f9B7Did;tpSd#>nXufhPa6uUC?KbwTDj*SId3HA}qL7Td{3qZ|VCDo}|WYiNaH${D49vPN0UXK13kg)>nB)'
        b'GbIu<mC1jhVsxN%NJ!kN%I$wi`1I',
    '2.4.6, protocol 5':
        b'c-n1|PfNov7{-&d8-)oDrs7BFX{dPcAZ{>FS+EDeql~n+bg*utYr%nnm(3|JDEPYX;5YE@7xL)Inr3m7u|V?V@9%kd^H6#}XGFDow1En'
        b'|Mw`?2Z<b{jpOxpbI-)ZN*w+X8Km$B${45>-jSy=6G#ZZU9d8i(bvgIru7^<R1o0qp(;)C;d_#M_M~dycp(o9SSX!%Ex3umy5lYHH>P<'
        b'2p`Vs~#IKrpdBVNj+2GC=49H%YwW@_LhL6<XbOc7`c6L}5j07J{3TmSx)7=#fM!wq2FgCgu?J&fhBQw?(!j4fFT<L(zRcWW^d3~LL-2w'
        b'(DQ-{LFK1Ua3^y;NbV8Y^UXW%u-2nOqgJhE-|7EpBpa1>Q&4DgH{7_L8oMV<D?p9(kfC@;}LW!Ql#TC34G@&JCO@tgrHsWu8q=^15hOb'
        b'0i{pV>_+?0eHE@@&',
}


def setUpModule():
    # As the program does: a changed byte can ask for any amount of memory.
    resource.setrlimit(resource.RLIMIT_AS, (512 << 20, resource.getrlimit(resource.RLIMIT_AS)[1]))


class Called:
    """An object that is pickled as a function call."""

    def __init__(self, *call):
        self.call = call

    def __reduce__(self):
        return self.call


def load_program():
    loader = importlib.machinery.SourceFileLoader('pickle_worker', str(PROGRAM))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def whole(data):
    """The pickle of a dict with the value of `data`, a pickle, as its metadata."""
    return b'\x80\x05}X\x08\0\0\0metadata' + data[:-1] + b's.'


def within(value):
    return {'metadata': value}


class PickleWorkerTest(unittest.TestCase):
    def setUp(self):
        self.program = load_program()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, 'sd_a.pkl')

    def read(self, data):
        """The metadata that are read, and the items of arrays."""
        Path(self.path).write_bytes(data)
        text, items = self.program.read(self.path, b'')
        return json.loads(text)['metadata'], items

    def read_value(self, value):
        return self.read(pickle.dumps(within(value)))[0]

    def assert_refused(self, data, problem):
        with self.assertRaisesRegex(self.program.Refused, problem) as caught:
            self.read(data)
        self.assertTrue(str(caught.exception).startswith(self.path), caught.exception)

    def test_reads_what_numpy_and_python_write(self):
        for writer, dumped in DUMPED.items():
            with self.subTest(writer):
                values, items = self.read(whole(zlib.decompress(base64.b85decode(dumped))))
                self.assertEqual(values.pop('a'), [1, -2, 3000, 2 ** 40, True, None, 'é'])
                self.assertEqual({key: values.pop(key) for key in 'fstn'}, {'f': 1.5, 's': ['x'], 't': [1], 'n': 0.5})
                self.assertEqual(values.pop('u'), ['ab', 'c'])
                arrays = {}
                for key, value in values.items():
                    self.assertEqual(sorted(value), ['at', 'dtype', 'ndarray'])
                    items_of_type = array.array('q' if value['dtype'] == 'i8' else 'd', items)
                    count = self.program.math.prod(value['ndarray'])
                    arrays[key] = value['ndarray'], value['dtype'], list(items_of_type[value['at']:][:count])
                matrix = [2, 3], 'f8', [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
                self.assertEqual(arrays, {'m': matrix, 'same': matrix, 'o': ([2, 2], 'i8', [1, 2, 3, 4]),
                                          'b': ([2], 'b1', [1.0, 0.0]), 'e': ([0, 2], 'f8', [])})

    def test_keeps_integers_exactly(self):
        number = 2 ** 53 + 1
        self.assertEqual(self.read_value([number, -2 ** 63, 2 ** 64 - 1]), [number, -2 ** 63, 2 ** 64 - 1])
        self.assertEqual(self.read_value([2 ** 64, -2 ** 63 - 1, 1]), [{'other': 'int'}, {'other': 'int'}, 1])

    def test_reads_what_it_writes(self):
        value = {'a': 1, 'b': [1.5, None, True], 'c': {'ndarray': [2, 1], 'dtype': 'f8', 'at': 1},
                 'd': {'ndarray': [2], 'dtype': 'b1', 'at': 3}, 'e': {'ndarray': [1], 'dtype': 'i8', 'at': 5}}
        items = struct.pack('=5dq', 7.0, 1.0, 2.0, 0.0, 1.0, 2 ** 53 + 1)
        written = self.program.write(json.dumps(within(value)), items)[1]
        read, read_items = self.read(written)
        for key in 'cde':
            value[key]['at'] -= 1
        self.assertEqual((read, read_items), (value, items[8:]))

    def test_a_summary_holds_the_metadata_of_each_file(self):
        content = '{"metadata": {"ts": {"ndarray": [1], "dtype": "f8", "at": 0}}}'
        self.read(self.program.write(content, struct.pack('=d', 3.0))[1])
        summary = self.program.summarize(json.dumps({'x': self.path, 'y': self.path}), b'')[1]
        values, items = self.read(whole(summary))
        self.assertEqual((list(values), items), (['x', 'y'], struct.pack('=2d', 3.0, 3.0)))

    def test_runs_nothing(self):
        proof = self.path + '.run'
        for call in ((os.system, ('touch ' + proof,)), (eval, ('1',)), (getattr, ('', 'join')), (open, (proof, 'w'))):
            self.assertEqual(self.read_value(Called(*call)), {'other': call[0].__name__})
        self.assertFalse(os.path.exists(proof))

    def test_refuses_what_is_cut_anywhere(self):
        for dumped in DUMPED.values():
            data = zlib.decompress(base64.b85decode(dumped))
            for length in range(len(data)):
                self.assert_refused(data[:length], '')

    def test_any_changed_byte_is_read_or_refused(self):
        for dumped in DUMPED.values():
            data = zlib.decompress(base64.b85decode(dumped))
            for place in range(2, len(data) - 1):
                try:
                    self.read(whole(data[:place] + bytes([data[place] ^ 0x41]) + data[place + 1:]))
                except self.program.Refused:
                    pass

    def test_values_that_are_not_plain_cost_themselves_alone(self):
        deep = []
        for _ in range(100):
            deep = [deep]
        cyclic = []
        cyclic.append(cyclic)
        for value in (deep, cyclic):
            read = self.read_value([value, 1])
            self.assertEqual(read[1], 1)
            self.assertRegex(json.dumps(read), r'^\[{21}\{"other": "list"\}')
        self.assertEqual(self.read_value({(1, 2): 3, None: 4, 5: 6, 'a': {'ndarray': 7}, 'b': b'8', 'c': 9j}),
                         {'5': 6, 'a': {'other': 'dict'}, 'b': {'other': 'bytes'}, 'c': {'other': 'complex'}})
        self.assert_refused(b'(' * 100_000 + b't' * 100_000 + b'.', 'is no dict with "metadata"')

    def array(self, name, shape, content):
        data_type = Called(self.program.DTYPE, (name,), (3, '<'))
        return Called(self.program.RECONSTRUCT, (0, (0,), b''), (1, shape, data_type, False, content))

    def test_reads_arrays_of_texts_and_objects(self):
        texts = self.array('U2', (2,), 'a'.encode('utf-32-le') + b'\0' * 4 + 'bc'.encode('utf-32-le'))
        values = {'texts': texts, 'objects': self.array('O8', (2,), [None, {'a': 1}]),
                  'too short': self.array('U2', (2,), b'\0' * 8), 'table': self.array('O8', (1, 2), [1, 2]),
                  'record': self.array('V8', (1,), b'\0' * 8), 'large': self.array('u8', (1,), b'\xff' * 8)}
        self.assertEqual(self.read_value(values),
                         {'texts': ['a', 'bc'], 'objects': [None, {'a': 1}], 'too short': {'other': 'Array'},
                          'table': {'other': 'Array'}, 'record': {'other': 'Array'}, 'large': {'other': 'Array'}})

    def test_refuses_values_beyond_its_limits(self):
        many = []
        for _ in range(15):
            many = [many] * 10
        self.program.MOST_VALUES = 1000
        self.assert_refused(pickle.dumps(within(many)), 'has more than 1,000 values')
        self.program.MOST_BYTES = 10
        self.assert_refused(pickle.dumps(within('a long text')), 'is longer than 256 MiB')


def ask(kind, text):
    """Kind and text of the program's answer."""
    ours, its = socket.socketpair()
    with subprocess.Popen(['/bin/sh', '-c', 'exec "$0" 3<&' + str(its.fileno()), PROGRAM], pass_fds=[its.fileno()]):
        its.close()
        with ours, ours.makefile('rwb') as stream:
            stream.write(struct.pack('=3Q', ord(kind), len(text), 0) + text)
            stream.flush()
            answer, size, _ = struct.unpack('=3Q', stream.read(24))
            return chr(answer) + stream.read(size).decode()


if __name__ == '__main__':
    unittest.main()
