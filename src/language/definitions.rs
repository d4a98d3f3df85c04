//! The definitions of a file: each is read once, none leads back to itself but by a recursion that ends.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::complaint::{Complaint, Fault, Origin, Place, fault};
use super::known::{Kind, Known, Subjects};
use super::raw::{Head, Node, Parser, Raw, whole};
use super::resolve::{Named, Scope};
use super::syntax::{Definition, Int, Name, Pattern, Real};

/// Which of the two texts of a definition a fault is in.
pub(super) type InDefinition = (usize, bool, Fault);

impl Known {
    /// Nothing but these definitions, each a head with its body: `b[i,0](x)` and `d[i]`.
    ///
    /// # Errors
    /// The first fault, with its place in the text that it is in.
    pub fn defining(texts: &[(&str, &str)]) -> Result<Self, Complaint> {
        let owned: Vec<_> =
            texts.iter().map(|(head, body)| ((*head).to_owned(), (*body).to_owned())).collect();
        definitions(&owned, Self::default()).map_err(|mut faults| {
            let (at, in_head, fault) = faults.swap_remove(0);
            let (head, body) = texts[at];
            let text = if in_head { head } else { body }.to_owned();
            let origin = Arc::new(Origin { name: format!("define {head}"), text });
            Complaint::new(&origin, fault.at, fault.rule, fault.advice)
        })
    }
}

/// Reads the definitions `head = body` of a file; they may speak of what is known already.
pub(super) fn definitions(texts: &[(String, String)], mut known: Known) -> Result<Known, Vec<InDefinition>> {
    let mut faults = Vec::new();
    let mut at = Vec::new();
    for (index, (text, _)) in texts.iter().enumerate() {
        match whole(text, Parser::head).and_then(|head| heading(&head, &known.definitions)) {
            Ok(definition) => {
                known.definitions.push(definition);
                at.push(index);
            }
            Err(fault) => faults.push((index, true, fault)),
        }
    }
    let mut bodies: Vec<(Real, Subjects, Named)> = Vec::new();
    for (definition, &index) in known.definitions.iter().zip(&at) {
        match body(definition, &texts[index].1, &known) {
            Ok(read) => bodies.push(read),
            Err((in_head, fault)) => faults.push((index, in_head, fault)),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut calls = Vec::new();
    for (definition, (body, subjects, named)) in known.definitions.iter_mut().zip(bodies) {
        definition.body = body;
        known.subjects.entry(Arc::clone(&definition.name)).or_default().join(&subjects);
        calls.push(named.definitions);
    }
    let in_body = |(index, fault): (usize, Fault)| vec![(at[index], false, fault)];
    recursions(&known.definitions, &calls).map_err(in_body)?;
    known.leads = leads(&known, &calls).map_err(in_body)?;
    let own = known.subjects.clone();
    for (name, leads) in &known.leads {
        for other in leads {
            known.subjects.entry(Arc::clone(name)).or_default().join(&own[other]);
        }
    }
    Ok(known)
}

fn heading(head: &Head, before: &[Definition]) -> Result<Definition, Fault> {
    let pattern = |node: &Node| match &node.raw {
        Raw::Number(text) if text.parse::<i64>().is_ok() => {
            Ok(Pattern::Number(text.parse().unwrap_or_default()))
        }
        Raw::Name { name, primes: 0 } => Ok(Pattern::Any(name.as_str().into())),
        _ => fault(
            &node.at,
            "an index of a definition is a name or a number",
            "write `b[i,q](x)` or `b[i,0](x)`",
        ),
    };
    let indices = head.indices.iter().map(pattern).collect::<Result<Vec<_>, _>>()?;
    let variable = head.variable.as_ref().map(|(name, _)| Name::from(name.as_str()));
    for other in before.iter().filter(|other| *other.name == *head.name) {
        if other.indices.len() != indices.len() || other.variable.is_some() != variable.is_some() {
            return fault(
                &head.at,
                format!("`{}` is defined in two shapes", head.name),
                format!("write it like `{}`, or give it another name", other.head()),
            );
        }
        let covers = |(a, b): (&Pattern, &Pattern)| matches!(a, Pattern::Any(_)) || a == b;
        if other.indices.iter().zip(&indices).all(covers) {
            let advice = "the first definition that fits is meant: put literals before names, and each once";
            return fault(&head.at, format!("`{}` comes first and always fits", other.head()), advice);
        }
    }
    Ok(Definition { name: head.name.as_str().into(), indices, variable, body: Real::Whole(Int::Number(0)) })
}

/// The body, what it speaks of, and which definitions it names. A fault is in the head or in the body.
fn body(
    definition: &Definition,
    text: &str,
    known: &Known,
) -> Result<(Real, Subjects, Named), (bool, Fault)> {
    // A name of its own may not be one of the other definitions, nor reserved.
    let mut scope =
        Scope { known, has: Subjects::default(), defining: true, own: Vec::new(), named: Named::default() };
    let whole_head = 0..definition.name.len();
    let own = definition.indices.iter().filter_map(|index| match index {
        Pattern::Any(name) => Some((name, Kind::Int)),
        Pattern::Number(_) => None,
    });
    super::resolve::not_reserved(&definition.name, &whole_head).map_err(|fault| (true, fault))?;
    let mut parameters = known.family.iter().flat_map(|family| &family.parameters);
    if parameters.any(|(name, _)| *name == definition.name) {
        let rule = format!("`{}` is a parameter already", definition.name);
        let advice = "take another name: none hides another".to_owned();
        return Err((true, Fault { at: whole_head, rule, advice }));
    }
    for (name, kind) in own.chain(definition.variable.as_ref().map(|name| (name, Kind::Real))) {
        scope.free(name, &whole_head).map_err(|fault| (true, fault))?;
        scope.own.push((Arc::clone(name), kind));
    }
    let node = whole(text, Parser::expression).map_err(|fault| (false, fault))?;
    let real = scope.real(&node).map_err(|fault| (false, fault))?;
    Ok((real, scope.has, scope.named))
}

type Calls = Vec<(Name, Vec<Int>, Place)>;

/// A definition names itself only with an index that falls to a literal.
fn recursions(all: &[Definition], calls: &[Calls]) -> Result<(), (usize, Fault)> {
    for (index, definition) in all.iter().enumerate() {
        let own: Vec<_> = calls[index].iter().filter(|(name, ..)| *name == definition.name).collect();
        let falls = (0..definition.indices.len()).any(|position| falls(definition, &own, position, all));
        if let (Some((_, _, at)), false) = (own.first(), falls) {
            let name = &definition.name;
            let advice =
                format!("let an index fall to a literal that is defined: `{name}[q-1]` and `{name}[0]`");
            return Err((
                index,
                Fault { at: at.clone(), rule: format!("the recursion of `{name}` never ends"), advice },
            ));
        }
    }
    Ok(())
}

/// What a definition leads to: all that those lead to that it names. None leads back.
fn leads(known: &Known, calls: &[Calls]) -> Result<BTreeMap<Name, BTreeSet<Name>>, (usize, Fault)> {
    let mut leads: BTreeMap<Name, BTreeSet<Name>> = BTreeMap::new();
    for (definition, calls) in known.definitions.iter().zip(calls) {
        let others = calls.iter().map(|(name, ..)| Arc::clone(name)).filter(|name| *name != definition.name);
        leads.entry(Arc::clone(&definition.name)).or_default().extend(others);
    }
    for _ in &known.definitions {
        for name in leads.keys().cloned().collect::<Vec<_>>() {
            let farther: Vec<_> = leads[&name].iter().flat_map(|next| leads[next].clone()).collect();
            leads.entry(name).or_default().extend(farther);
        }
    }
    for (index, (definition, calls)) in known.definitions.iter().zip(calls).enumerate() {
        let name = &definition.name;
        let back = calls.iter().find(|(other, ..)| other != name && leads[other].contains(name));
        if let Some((other, _, at)) = back {
            let rule = format!("`{name}` is defined by `{other}`, and that by `{name}`");
            let advice = "a definition stands for a term without itself".to_owned();
            return Err((index, Fault { at: at.clone(), rule, advice }));
        }
    }
    Ok(leads)
}

/// Does each call lower this index by a step that literals catch?
fn falls(
    definition: &Definition,
    calls: &[&(Name, Vec<Int>, Place)],
    position: usize,
    all: &[Definition],
) -> bool {
    let Pattern::Any(name) = &definition.indices[position] else { return false };
    let literals: Vec<i64> = all
        .iter()
        .filter(|other| other.name == definition.name)
        .filter_map(|other| match other.indices[position] {
            Pattern::Number(number) => Some(number),
            Pattern::Any(_) => None,
        })
        .collect();
    calls.iter().all(|(_, by, _)| match &by[position] {
        Int::Minus(a, b) => match (&**a, &**b) {
            (Int::Bound(bound), Int::Number(step)) if bound == name && (1..100).contains(step) => literals
                .iter()
                .any(|first| (*first..first.saturating_add(*step)).all(|n| literals.contains(&n))),
            _ => false,
        },
        _ => false,
    })
}
