const name = document.getElementById('name'), details = document.getElementById('details');
const cell = (head, text) => `<td>${head}<br><b>${text}</b></td>`;
const spread = s => `${s[0].toPrecision(4)} (${s[1].toPrecision(2)})`;
function show(row) {
  document.querySelectorAll('.chosen').forEach(one => one.classList.remove('chosen'));
  document.querySelectorAll(`.point[data-row="${row}"]`).forEach(one => one.classList.add('chosen'));
  const r = ROWS[row];
  details.innerHTML = '<table><tr></tr></table><code></code>';
  details.querySelector('tr').innerHTML = cell(r.scene, r.configuration) + cell('pass 1', spread(r.moments)) +
    cell('pass 2', spread(r.color)) + cell('composite', spread(r.composite)) + cell('total', spread(r.total)) +
    cell('difference', spread(r.differential)) + cell('stored bits', r.stored ?? 'grow') +
    cell('bits with factor', r.bits ?? 'grow') + cell('passes', r.passes ?? 'layers') +
    cell('RMSE', r.rmse) + cell('ΔE', r.delta_e) + cell('FLIP', r.flip) + cell('stability', r.stability);
  details.querySelector('code').textContent = r.command;
}
document.querySelectorAll('.point').forEach(point => {
  const row = point.dataset.row;
  point.querySelector('title').remove();
  point.addEventListener('mousemove', event => {
    name.textContent = `${ROWS[row].configuration}: ${ROWS[row].total[0].toPrecision(3)} ms`;
    name.style.cssText = `display:block;left:${event.pageX + 14}px;top:${event.pageY + 10}px`;
  });
  point.addEventListener('mouseleave', () => name.style.display = 'none');
  point.addEventListener('click', () => show(row));
});
document.querySelectorAll('input').forEach(input =>
  input.addEventListener('change', () => document.body.className = input.value));
