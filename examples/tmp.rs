use knotproof::claims::*;
fn main(){
  let t=std::time::Instant::now();
  let cases=Cases::all();
  println!("{} bases {} weights", cases.bases.len(), cases.weights.len());
  let filter=std::env::args().nth(1);
  for c in claims(){
    if let Some(f)=&filter { if !c.id.starts_with(f.as_str()) {continue} }
    let s=std::time::Instant::now();
    match c.judge(&cases){
      Err(f)=>println!("{} FAULT {f}",c.id),
      Ok(j)=>{
        let show=|v:&Verdict| match v { Verdict::Proved{reach,..}=>format!("proved {}+{} facts {} deg {:?} {:?}",reach.instances,reach.small_cases,reach.facts,reach.degrees,reach.remarks.iter().take(6).collect::<Vec<_>>()), Verdict::Refuted(w)=>format!("refuted {w}"), Verdict::Undecided(l)=>format!("undecided {l}"), v=>format!("{v:?}")};
        println!("{:24} {:6}ms {}",c.id,s.elapsed().as_millis(),show(&j.printed));
        if let Some(a)=&j.amended {println!("      amended: {} {:?}",show(a),j.sharpness)}
        for (d,v) in &j.by_degree {println!("      k={d}: {}",show(v))}
      }
    }
  }
  println!("total {:?}",t.elapsed());
}
