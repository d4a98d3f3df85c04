"""Claims on a basis, papers, and what verdicts are."""

import dataclasses
import pickle
import re
from fractions import Fraction
from pathlib import Path

import pytest

from knotproof import Basis, Verdict, Verdicts, judge


@pytest.fixture(scope="module")
def verdicts():
    return Basis("0 0 0 1 1 1 2 2 2", 2, alpha=-1).check("T3.5.1", "T3.5.3")


def test_a_refuted_claim_has_a_witness_and_its_amendment(verdicts):
    verdict = verdicts["T3.5.1"]
    assert (verdict.status, verdict.is_refuted, verdict.is_proved, verdict.is_undecided) == ("refuted", True, False, False)
    assert verdict.amended.is_proved and verdict.amended.form == "amended"
    witness = verdict.witness
    assert witness.basis == Basis("0 0 0 1 1 1 2 2 2", 2, alpha=-1) and witness["k"] == 2
    assert witness.basis.B(witness["x"])[witness["i"]] != 0
    assert witness.again.startswith("knotproof eval ") and isinstance(witness["x"], Fraction)
    with pytest.raises(KeyError, match="'y': there are "):
        witness["y"]


def test_a_verdict_is_no_truth_value(verdicts):
    for wrong in (lambda: bool(verdicts[0]), lambda: not verdicts[0], lambda: 1 if verdicts[0] else 2):
        with pytest.raises(TypeError, match=r'is_proved, or verdict\.status == "proved"'):
            wrong()
    for some in (verdicts, Verdicts(())):
        with pytest.raises(TypeError, match=r"write all\("):
            bool(some)


def test_verdicts_are_frozen_and_compare(verdicts):
    with pytest.raises(dataclasses.FrozenInstanceError):
        verdicts[0].status = "proved"
    assert pickle.loads(pickle.dumps(verdicts[0])) == verdicts[0]
    assert isinstance(verdicts[:1], Verdicts) and verdicts.counts == {"refuted": 1, "proved": 1}
    with pytest.raises(KeyError, match="'T1': there are T3.5.1, T3.5.3"):
        verdicts["T1"]


def test_verdicts_are_shown_in_notebooks(verdicts):
    html = verdicts._repr_html_()
    assert html.count("<tr>") == 2 and "<math" in html and "refuted" in html
    assert "<td>-1</td>" in verdicts[0].witness._repr_html_()
    assert "$" in verdicts[0]._repr_latex_() and verdicts[0]._repr_html_().startswith("<table>")
    assert re.match(r"<1 refuted, 1 proved>\n  T3.5.1  refuted\n  T3.5.3  proved", repr(verdicts))
    assert "at " in str(verdicts[0]) and repr(verdicts[0]) == "<T3.5.1: refuted>"


def test_the_papers_claims_are_those_about_knots():
    verdicts = Basis("0 0 0 1 2 2 2", 2, alpha=-1).check()
    assert len(verdicts) > 30 and verdicts["T3.5.2"].is_proved
    assert all(verdict.amended is None or verdict.amended.status != "refuted" for verdict in verdicts)


def test_own_sentences():
    basis = Basis("0 0 0 1 2 2 2", 2, alpha=-1)
    (true,) = basis.check(sentence="i in 0..n; x in [t[0], t[m]] : G[i](x) <= 1")
    (false,) = basis.check(sentence="i in 0..n; x in [t[0], t[m]] : G[i](x) < 1")
    assert true.is_proved and true.scope == "instance" and false.witness["x"] == 0
    with pytest.raises(ValueError, match=r"(?s)sentence: .*\n.*\^"):
        basis.check(sentence="i in 0..n : G[i](x) <= 1")
    with pytest.raises(ValueError, match="it stands alone"):
        basis.check("T3.5.1", sentence="1 < 2")


def test_unknown_claims_say_which_there_are():
    basis = Basis("0 0 1 1", 1, alpha=-1)
    with pytest.raises(ValueError, match="claims: there is no claim `T3.5.9`; there are .*T3.5.1"):
        basis.check("T3.5.9")
    with pytest.raises(ValueError, match="Ill5.5.1 is about examples of the paper"):
        basis.check("Ill5.5.1")
    with pytest.raises(ValueError, match="paper: there is no folder `nowhere`"):
        basis.check(paper="nowhere")


def test_claims_about_a_family_are_judged_on_its_members():
    with pytest.raises(ValueError, match="alpha: the family `pq-lupas` of the paper has no index -1; write family pq-lupas"):
        Basis("0 0 0 1 1 1", 2, alpha=-1).check(paper="pq")
    assert Basis("0 0 0 1 1 1", 2, family="pq-lupas", p=1, q="3/2").check(paper="pq").counts["proved"] > 0


def test_another_family_is_asked_for_classical_properties():
    verdicts = Basis("0 0 0 1 2 2 2", 2, family="lupas", q="1/2").check()
    assert verdicts["unity"].is_proved and verdicts["C1"].is_refuted
    assert verdicts["C1"].witness.basis.family == "lupas"
    same = Basis("0 0 0 1 2 2 2", 2, alpha="inf").check("C1", classical=True)
    assert same["C1"].is_proved


def test_claims_about_curves_are_about_these_points():
    curve = Basis("0 0 0 1 2 2 2", 2, alpha=5).curve([(0, 0), (1, 2), (2, 2), (3, 0)])
    assert curve.check("P4.1.3")[0].is_proved


def test_a_paper_is_judged_in_its_order():
    judging = judge("classical", ["Greville", "Elevation"])
    assert judging.total == len(judging) == 2
    first = next(judging)
    assert isinstance(first, Verdict) and len(judging) == 1
    second = judging.verdicts()[0]
    assert [verdict.claim for verdict in (first, second)] == [v.claim for v in judge("classical", ("Elevation", "Greville"))]
    assert judging.done == 2 and list(judging) == []


def test_degrees_are_kept_to():
    (verdict,) = judge("classical", "Greville", degrees=1)
    assert verdict.degrees == (1,)
    with pytest.raises(ValueError, match="degrees: 3 is above 1"):
        judge("classical", degrees=(3, 1))


def test_a_folder_is_judged_as_the_paper_that_comes_along():
    folder = Path(__file__).parents[2] / "papers" / "classical"
    own, known = (judge(paper, "Greville", degrees=(1, 2)).verdicts() for paper in (folder, "classical"))
    assert own == known and own.counts == {"proved": 1}


def test_what_is_wrong_in_a_folder_has_its_place(tmp_path):
    with pytest.raises(ValueError, match="paper: there is no folder `.*`, and no paper of that name"):
        judge(tmp_path / "none")
    (tmp_path / "claims").mkdir()
    (tmp_path / "paper.toml").write_text("title = ")
    with pytest.raises(ValueError, match=r"(?s)paper: .*paper\.toml"):
        judge(tmp_path)


def test_unknown_claims_of_a_paper():
    with pytest.raises(ValueError, match="claims: there is no claim `Grevill`; there are Greville"):
        judge("classical", ["Grevill"])
